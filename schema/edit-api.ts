import * as z from 'zod';
import { rulesSchema } from './rules.ts';

/**
 * What the editor's page and `gq edit` say to each other: JSON over HTTP, on 127.0.0.1 alone.
 *
 * The address that `gq edit` prints ends in `#token=TOKEN`; every request below `/api/` sends it in the header `TOKEN_HEADER`.
 * Every answer that is not 2xx is an `ErrorResponse`.
 *
 * | request                      | headers                          | body               | answer                        |
 * | ---------------------------- | -------------------------------- | ------------------ | ----------------------------- |
 * | GET  LEVELS                  |                                  |                    | 200 `ListResponse`            |
 * | GET  LEVEL?id=ID             |                                  |                    | 200 `ReadResponse`            |
 * | PUT  LEVEL?id=ID             | If-Match: ETAG                   | `WriteRequest`     | 200 `WriteResponse`           |
 * | PUT  LEVEL?id=ID             | If-None-Match: * (a new level)   | `WriteRequest`     | 201 `WriteResponse`           |
 * | POST RENAME                  | If-Match: ETAG                   | `RenameRequest`    | 200 `WriteResponse`           |
 * | POST DUPLICATE               | If-Match: ETAG                   | `RenameRequest`    | 201 `WriteResponse`           |
 * | POST DELETE                  | If-Match: ETAG                   | `DeleteRequest`    | 200 `DeleteResponse`          |
 * | GET  TRASH                   |                                  |                    | 200 `TrashResponse`           |
 * | POST RESTORE                 |                                  | `RestoreRequest`   | 201 `WriteResponse`           |
 * | POST ORDER                   |                                  | `OrderRequest`     | 200 `OrderResponse`           |
 * | GET  EVENTS                  |                                  |                    | 200 text/event-stream         |
 *
 * Bodies have `Content-Type: application/json` and nothing after it, and at most `MAX_BODY_SIZE` bytes. An ETAG is used as it was given,
 * quotes and all. `EVENTS` is to be read by `fetch`, since an EventSource can't send the token: each event is a line `data: ` with an
 * `EditEvent`, then an empty line; lines that begin with `:` come every `HEARTBEAT` seconds, so that silence means the server is gone.
 */
export const EDIT_API = {
  LEVELS: '/api/levels',
  LEVEL: '/api/level',
  RENAME: '/api/rename',
  DUPLICATE: '/api/duplicate',
  DELETE: '/api/delete',
  TRASH: '/api/trash',
  RESTORE: '/api/restore',
  ORDER: '/api/order',
  EVENTS: '/api/events',
  TOKEN_HEADER: 'x-gq-token',
  /** bytes */
  MAX_BODY_SIZE: 1024 * 1024,
  /** s */
  HEARTBEAT: 10,
} as const;

const etag = z
  .string()
  .regex(/^"[0-9a-f]{64}"$/)
  .describe("SHA-256 of the file's bytes, in quotes: as If-Match takes it.");

const id = z
  .string()
  .min(1)
  .max(4096)
  .describe('Path of the file below the folder, with slashes, without .level.json: `07-slingshot`, `world-2/01-start`.');

/** What a new file may be called, each part of its id: letters, digits, _ - and spaces, so that it is the same file on every system. */
export const LEVEL_ID_PART = /^(?!(?:con|prn|aux|nul|com\d|lpt\d)$)[a-z0-9](?:[a-z0-9 _-]{0,78}[a-z0-9_-])?$/i;

const client = z
  .string()
  .regex(/^[\w-]{1,64}$/)
  .describe('Random name of one page, so that it knows its own changes among the events.');

const problem = z.strictObject({
  code: z.string(),
  severity: z.enum(['error', 'warning']),
  message: z.string(),
  hint: z.string(),
  pointer: z.string(),
  line: z.int().min(1).nullable(),
  column: z.int().min(1).nullable(),
});

/** One file of the folder. */
export const levelEntrySchema = z.strictObject({
  id,
  file: z.string().describe('Path of the file as `gq check` takes it, from where `gq edit` was started.'),
  etag: etag.nullable().describe('null when the file could not be read.'),
  status: z.enum(['valid', 'invalid', 'unreadable']),
  name: z.string().nullable().describe("The level's name; null unless it is valid."),
  problems: z.array(problem).describe('Why it is not valid.'),
  readOnly: z.string().nullable().describe('Why the editor may not write to it, for people; null when it may.'),
});
export type LevelEntry = z.infer<typeof levelEntrySchema>;

/** Rules that hold for the levels of the folder where they have none of their own: `rules` of the `gq.config.json` that `gq check` would take, too. */
export const folderRulesSchema = z.strictObject({
  file: z.string().nullable().describe('The configuration, as a person names it; null: there is none.'),
  own: rulesSchema.describe("Those that are not the game's own."),
  problems: z.array(problem).describe('Why the configuration is not valid: `own` is then what it set when it was.'),
});
export type FolderRules = z.infer<typeof folderRulesSchema>;

export const listResponseSchema = z.strictObject({
  folder: z.strictObject({
    id: z
      .string()
      .describe('The same for the same folder in every run: what a page keeps for a folder, it keeps under this name.'),
    path: z.string().describe('For people.'),
    $schema: z.string().nullable().describe('What a new level directly in the folder says in `$schema`; null: nothing.'),
  }),
  folders: z.array(z.string()).describe("'' and every folder below it that levels can be put into, with slashes."),
  levels: z.array(levelEntrySchema).describe('In the order of play: by path, numbers by their value.'),
  rules: folderRulesSchema,
  troubles: z.array(z.string()).describe('What is wrong with the folder as a whole, for people; mostly nothing.'),
  unread: z.int().min(0).describe('Levels that are still to come, as events `read`; 0: these are all.'),
});
export type ListResponse = z.infer<typeof listResponseSchema>;

export const readResponseSchema = z.strictObject({
  ...levelEntrySchema.shape,
  text: z.string().nullable().describe('The file as it is, valid or not; null when it could not be read.'),
});
export type ReadResponse = z.infer<typeof readResponseSchema>;

/** The whole new text of a level. It is stored as it is, and only when it is a valid level. */
export const writeRequestSchema = z.strictObject({ text: z.string(), client });
export type WriteRequest = z.infer<typeof writeRequestSchema>;

export const writeResponseSchema = z.strictObject({ entry: levelEntrySchema });
export type WriteResponse = z.infer<typeof writeResponseSchema>;

/** `to`: the new id, in a folder that exists; its last part is a name as `LEVEL_ID_PART` has it. The file's content stays. */
export const renameRequestSchema = z.strictObject({ id, to: id, client });
export type RenameRequest = z.infer<typeof renameRequestSchema>;

export const deleteRequestSchema = z.strictObject({ id, client });
export type DeleteRequest = z.infer<typeof deleteRequestSchema>;

/** A level that was deleted: its file was moved below `.gq-trash`, where it stays until somebody removes it by hand. */
export const trashEntrySchema = z.strictObject({
  trash: z.string().describe('What `RESTORE` takes.'),
  id: id.describe('Its id before it was deleted.'),
  deleted: z.string().describe('When, ISO 8601.'),
});
export type TrashEntry = z.infer<typeof trashEntrySchema>;

export const deleteResponseSchema = z.strictObject({ trashed: trashEntrySchema });
export type DeleteResponse = z.infer<typeof deleteResponseSchema>;

export const trashResponseSchema = z.strictObject({ trash: z.array(trashEntrySchema).describe('The last one deleted first.') });
export type TrashResponse = z.infer<typeof trashResponseSchema>;

/** `to`: where it goes; its old id when left out. */
export const restoreRequestSchema = z.strictObject({ trash: z.string().min(1).max(4200), to: id.optional(), client });
export type RestoreRequest = z.infer<typeof restoreRequestSchema>;

/** Every level of one folder ('' for the outermost) in the wanted order. Files are renamed: `07-slingshot` becomes `03-slingshot`. */
export const orderRequestSchema = z.strictObject({ folder: z.string().max(4096), ids: z.array(id).max(100_000), client });
export type OrderRequest = z.infer<typeof orderRequestSchema>;

export const orderResponseSchema = z.strictObject({
  renamed: z.array(z.strictObject({ from: id, to: id })),
  levels: z.array(levelEntrySchema).describe('All levels, as in `ListResponse`.'),
});
export type OrderResponse = z.infer<typeof orderResponseSchema>;

const by = client.nullable().describe('Who did it: null for another program.');

/** What the server tells of its own accord. `list` comes first, and again when everything may be different. */
export const editEventSchema = z.discriminatedUnion('type', [
  z.strictObject({ type: z.literal('list'), list: listResponseSchema }),
  z
    .strictObject({ type: z.literal('read'), levels: z.array(levelEntrySchema), unread: z.int().min(0) })
    .describe('More of a list that came without them, since they are many, or are only now read.'),
  z.strictObject({ type: z.literal('changed'), entry: levelEntrySchema, by }).describe('New, or with another content.'),
  z.strictObject({ type: z.literal('removed'), id, by }),
  z.strictObject({ type: z.literal('rules'), rules: folderRulesSchema }).describe('The configuration has changed.'),
  z.strictObject({ type: z.literal('renamed'), from: id, entry: levelEntrySchema, by }),
]);
export type EditEvent = z.infer<typeof editEventSchema>;

/** What an `ErrorResponse` can be about, with its status. */
export const EDIT_ERRORS = {
  'wrong-host': 403,
  'foreign-page': 403,
  'upgrade-refused': 400,
  'wrong-token': 401,
  'unknown-address': 404,
  'wrong-method': 405,
  'wrong-content-type': 415,
  'body-too-large': 413,
  'bad-request': 400,
  'bad-name': 400,
  'unknown-level': 404,
  'unknown-folder': 404,
  'name-taken': 409,
  'list-changed': 409,
  'base-missing': 428,
  conflict: 412,
  'invalid-level': 422,
  'not-writable': 403,
  'disk-full': 507,
  busy: 503,
  failed: 500,
} as const;
export type EditErrorCode = keyof typeof EDIT_ERRORS;

/** The answer to a request that was refused: nothing has changed on the disk. */
export const errorResponseSchema = z.strictObject({
  error: z.strictObject({
    code: z.enum(Object.keys(EDIT_ERRORS) as [EditErrorCode, ...EditErrorCode[]]),
    message: z.string().describe('What was expected and what was found.'),
    hint: z.string().describe('What to do.'),
    problems: z.array(problem).optional().describe('`invalid-level`: what is wrong with the text, and where.'),
    current: readResponseSchema
      .nullable()
      .optional()
      .describe('`conflict`: what is on the disk instead of the base; null: there is no such file any more.'),
  }),
});
export type ErrorResponse = z.infer<typeof errorResponseSchema>;
