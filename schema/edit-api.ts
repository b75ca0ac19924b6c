import * as z from 'zod';
import { VERDICTS } from './basics/index.ts';
import { ACCURACY_NAMES } from './config/index.ts';
import { rulesSchema } from './level-schema.ts';

/**
 * The protocol between the editor and the server of `gq edit`: JSON over HTTP, on 127.0.0.1 only.
 *
 * The address that `gq edit` prints ends in `#token=TOKEN`. Every request below `/api/` sends the token in the header
 * `TOKEN_HEADER`. Every response with a status other than 2xx has an {@link ErrorResponse} as its body.
 *
 * | request                      | headers                          | body               | response                      |
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
 * | PUT  PACK                    | If-Match: ETAG                   | `PackRequest`      | 200 `PackResponse`            |
 * | PUT  PACK                    | If-None-Match: * (a new file)    | `PackRequest`      | 200 `PackResponse`            |
 * | POST PUBLISH                 |                                  | `PublishRequest`   | 200 `PublishResponse`         |
 * | GET  EVENTS                  |                                  |                    | 200 text/event-stream         |
 *
 * Bodies have exactly `Content-Type: application/json`, without parameters, and at most `MAX_BODY_SIZE` bytes. An ETAG is sent
 * back exactly as it was received, quotes included.
 *
 * Read `EVENTS` with `fetch`, since an EventSource cannot send the token. Each event is a line `data: ` with an {@link
 * EditEvent}, followed by an empty line. A line that begins with `:` comes every `HEARTBEAT` seconds, so silence means that the
 * server is gone.
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
  PACK: '/api/pack',
  PUBLISH: '/api/publish',
  EVENTS: '/api/events',
  /** The key of the folder, with which a page asks for the token of a later run. */
  KEY: '/api/key',
  /** Which run this is. It alone needs no token; without the key, the answer says nothing. */
  RUN: '/api/run',
  TOKEN_HEADER: 'x-gq-token',
  /** Largest body of a request, bytes. */
  MAX_BODY_SIZE: 1024 * 1024,
  /** Time between two signs of life in `EVENTS`, s. */
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

/**
 * What each part of a new level's id must match: letters, digits, `_`, `-` and spaces, so that the file has the same name on
 * every system.
 */
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

/** The zod schema of a level in the folder. */
export const levelEntrySchema = z.strictObject({
  id,
  file: z.string().describe('Path of the file as `gq check` takes it, from where `gq edit` was started.'),
  etag: etag.nullable().describe('null when the file could not be read.'),
  status: z.enum(['valid', 'invalid', 'unreadable']),
  name: z.string().nullable().describe("The level's name; null unless it is valid."),
  problems: z.array(problem).describe('Why it is not valid.'),
  readOnly: z.string().nullable().describe('Why the editor may not write to it, for people; null when it may.'),
});
/** A level in the folder. */
export type LevelEntry = z.infer<typeof levelEntrySchema>;

/** The zod schema of the folder's `pack.json`, the order in which its levels are played. */
export const packOnDiskSchema = z.strictObject({
  file: z.string().describe('Path of the file, for people.'),
  etag: etag.nullable().describe('null when the file could not be read.'),
  text: z.string().nullable().describe('The file as it is, valid or not; null when it could not be read.'),
  readOnly: z.string().nullable().describe('Why the editor may not write to it, for people; null when it may.'),
});
/** The folder's `pack.json`, the order in which its levels are played. */
export type PackOnDisk = z.infer<typeof packOnDiskSchema>;

/**
 * The zod schema of the terms under which `gq check` judges the levels of the folder: those of the `gq.config.json` that it would
 * use, and the defaults for what that leaves out.
 */
export const folderTermsSchema = z.strictObject({
  file: z.string().nullable().describe('The configuration, as a person names it; null: there is none.'),
  accuracy: z.enum(ACCURACY_NAMES).describe('How exactly levels are simulated.'),
  maxTime: z.number().positive().describe('The longest a run may last, s of simulated time.'),
  maxWork: z.int().min(1).describe('The work that one level may cost, pieces of motion.'),
  rules: rulesSchema.describe("The rules of levels without their own: those that are not the game's."),
  problems: z.array(problem).describe('Why the configuration is not valid: the terms are then those of when it was.'),
});
/** The terms under which `gq check` judges the levels of the folder. */
export type FolderTerms = z.infer<typeof folderTermsSchema>;

/** The zod schema of the response to `GET LEVELS`. */
export const listResponseSchema = z.strictObject({
  folder: z.strictObject({
    id: z
      .string()
      .describe('The same for the same folder in every run: what a page keeps for a folder, it keeps under this name.'),
    path: z.string().describe('For people.'),
    $schema: z.string().nullable().describe('What a new level directly in the folder says in `$schema`; null: nothing.'),
  }),
  folders: z.array(z.string()).describe("'' and every folder below it that levels can be put into, with slashes."),
  levels: z
    .array(levelEntrySchema)
    .describe('By path, numbers by their value: the order of play, where no pack.json says another one.'),
  pack: packOnDiskSchema.optional().describe('The pack.json of the folder; left out if there is none.'),
  terms: folderTermsSchema,
  troubles: z.array(z.string()).describe('What is wrong with the folder as a whole, for people; mostly nothing.'),
  unread: z.int().min(0).describe('Levels that are still to come, as events `read`; 0: these are all.'),
});
/** The response to `GET LEVELS`: the folder and its levels. */
export type ListResponse = z.infer<typeof listResponseSchema>;

/** The zod schema of the response to `GET LEVEL`. */
export const readResponseSchema = z.strictObject({
  ...levelEntrySchema.shape,
  text: z.string().nullable().describe('The file as it is, valid or not; null when it could not be read.'),
});
/** The response to `GET LEVEL`: a level with its text. */
export type ReadResponse = z.infer<typeof readResponseSchema>;

/** The zod schema of the body of `PUT LEVEL`: the whole new text. It is stored unchanged, and only if it is a valid level. */
export const writeRequestSchema = z.strictObject({ text: z.string(), client });
/** The body of `PUT LEVEL`. */
export type WriteRequest = z.infer<typeof writeRequestSchema>;

/** The zod schema of the response to every request that writes a level. */
export const writeResponseSchema = z.strictObject({ entry: levelEntrySchema });
/** The response to every request that writes a level. */
export type WriteResponse = z.infer<typeof writeResponseSchema>;

/**
 * The zod schema of the body of `POST RENAME` and `POST DUPLICATE`. `to` is the new id, in a folder that exists; its last part
 * matches `LEVEL_ID_PART`. The content of the file stays.
 */
export const renameRequestSchema = z.strictObject({ id, to: id, client });
/** The body of `POST RENAME` and `POST DUPLICATE`. */
export type RenameRequest = z.infer<typeof renameRequestSchema>;

/** The zod schema of the body of `POST DELETE`. */
export const deleteRequestSchema = z.strictObject({ id, client });
/** The body of `POST DELETE`. */
export type DeleteRequest = z.infer<typeof deleteRequestSchema>;

/**
 * The zod schema of a deleted level. Its file was moved below `.gq-trash` and stays there until somebody removes it by hand.
 */
export const trashEntrySchema = z.strictObject({
  trash: z.string().describe('What `RESTORE` takes.'),
  id: id.describe('Its id before it was deleted.'),
  deleted: z.string().describe('When, ISO 8601.'),
});
/** A deleted level. */
export type TrashEntry = z.infer<typeof trashEntrySchema>;

/** The zod schema of the response to `POST DELETE`. */
export const deleteResponseSchema = z.strictObject({ trashed: trashEntrySchema });
/** The response to `POST DELETE`. */
export type DeleteResponse = z.infer<typeof deleteResponseSchema>;

/** The zod schema of the response to `GET TRASH`. */
export const trashResponseSchema = z.strictObject({ trash: z.array(trashEntrySchema).describe('The last one deleted first.') });
/** The response to `GET TRASH`: the deleted levels. */
export type TrashResponse = z.infer<typeof trashResponseSchema>;

/** The zod schema of the body of `POST RESTORE`. `to` is the id to restore it under; its old id when left out. */
export const restoreRequestSchema = z.strictObject({ trash: z.string().min(1).max(4200), to: id.optional(), client });
/** The body of `POST RESTORE`. */
export type RestoreRequest = z.infer<typeof restoreRequestSchema>;

/**
 * The zod schema of the body of `POST ORDER`: all levels of one folder ('' is the outermost) in the wanted order. The files are
 * renamed: `07-slingshot` becomes `03-slingshot`.
 */
export const orderRequestSchema = z.strictObject({ folder: z.string().max(4096), ids: z.array(id).max(100_000), client });
/** The body of `POST ORDER`. */
export type OrderRequest = z.infer<typeof orderRequestSchema>;

/** The zod schema of the response to `POST ORDER`. */
export const orderResponseSchema = z.strictObject({
  renamed: z.array(z.strictObject({ from: id, to: id })),
  levels: z.array(levelEntrySchema).describe('All levels, as in `ListResponse`.'),
});
/** The response to `POST ORDER`. */
export type OrderResponse = z.infer<typeof orderResponseSchema>;

/**
 * The zod schema of the body of `PUT PACK`: the whole new text of `pack.json`, which is stored unchanged, and only if it is valid;
 * null: the file is removed.
 */
export const packRequestSchema = z.strictObject({ text: z.string().nullable(), client });
/** The body of `PUT PACK`. */
export type PackRequest = z.infer<typeof packRequestSchema>;

/** The zod schema of the response to `PUT PACK`: the file as it is now; null: there is none. */
export const packResponseSchema = z.strictObject({ pack: packOnDiskSchema.nullable() });
/** The response to `PUT PACK`. */
export type PackResponse = z.infer<typeof packResponseSchema>;

/**
 * The zod schema of the body of `POST PUBLISH`: a static page with the levels, as `gq build` makes it, in a folder beside that of
 * the levels. `site` matches `LEVEL_ID_PART`; the folder is new, empty, or of an earlier build.
 */
export const publishRequestSchema = z.strictObject({
  site: z.string().min(1).max(80).describe('The name of the folder.'),
  level: id.nullable().describe('This level alone; null: all levels.'),
  title: z.string().min(1).max(200),
  withRuns: z.boolean().describe('Whether the page has the runs of the levels, which give their solutions away.'),
  force: z.boolean().describe('Whether to publish levels that are not known to be completable.'),
  client,
});
/** The body of `POST PUBLISH`. */
export type PublishRequest = z.infer<typeof publishRequestSchema>;

/** The zod schema of the response to `POST PUBLISH`. */
export const publishResponseSchema = z.strictObject({
  site: z.string().describe('Path of the folder, for people.'),
  levels: z.int().min(1).describe('The number of levels on the page.'),
  bytes: z.int().min(1),
});
/** The response to `POST PUBLISH`. */
export type PublishResponse = z.infer<typeof publishResponseSchema>;

/** The zod schema of a level that is not published as it is. */
export const refusedLevelSchema = z.strictObject({
  id,
  name: z.string(),
  verdict: z.enum(VERDICTS),
  message: z.string().describe('What is wrong with it.'),
});
/** A level that is not published as it is. */
export type RefusedLevel = z.infer<typeof refusedLevelSchema>;

/** The zod schema of the response to `GET KEY`. */
export const keyResponseSchema = z.strictObject({ key: z.string().regex(/^[\w-]{43}$/) });

/** What a page sends to `GET RUN` as `challenge`: random, so that no earlier answer fits. */
export const CHALLENGE = /^[\w-]{22,64}$/;

/** The zod schema of the response to `GET RUN`. */
export const runResponseSchema = z.strictObject({
  nonce: z
    .string()
    .regex(/^[\w-]{22}$/)
    .describe('Of this run.'),
  proof: z
    .string()
    .regex(/^[\w-]{43}$/)
    .describe('The HMAC of {@link runMessage}: the server has the key.'),
});

/**
 * What the server proves by an HMAC-SHA256 with the key that it has it. It contains the port, so that a program which listens on the
 * port of an earlier run can't pass the question on to the server.
 * @param port on which the server listens
 * @param challenge what the page has sent
 * @param nonce that of the run
 * @returns the text to sign
 */
export const runMessage = (port: number, challenge: string, nonce: string): string =>
  `gq edit, run\n${port}\n${challenge}\n${nonce}`;

/**
 * The HMAC-SHA256 of this with the key is the token of a run.
 * @param nonce that of the run
 * @returns the text to sign
 */
export const tokenMessage = (nonce: string): string => `gq edit, token\n${nonce}`;

const by = client.nullable().describe('Who did it: null for another program.');

/** The zod schema of what the server sends unasked. `list` comes first, and again whenever everything may have changed. */
export const editEventSchema = z.discriminatedUnion('type', [
  z.strictObject({ type: z.literal('list'), list: listResponseSchema }),
  z
    .strictObject({ type: z.literal('read'), levels: z.array(levelEntrySchema), unread: z.int().min(0) })
    .describe('More of a list that came without them, since they are many, or are only now read.'),
  z.strictObject({ type: z.literal('changed'), entry: levelEntrySchema, by }).describe('New, or with another content.'),
  z.strictObject({ type: z.literal('removed'), id, by }),
  z.strictObject({ type: z.literal('terms'), terms: folderTermsSchema }).describe('The configuration has changed.'),
  z.strictObject({ type: z.literal('renamed'), from: id, entry: levelEntrySchema, by }),
  z
    .strictObject({ type: z.literal('pack'), pack: packOnDiskSchema.nullable(), by })
    .describe('The pack.json of the folder has changed; null: it is gone.'),
]);
/** An event that the server sends unasked. */
export type EditEvent = z.infer<typeof editEventSchema>;

/** The codes of an {@link ErrorResponse}, each with its HTTP status. */
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
  'invalid-pack': 422,
  'not-completable': 409,
  'not-published': 409,
  'not-writable': 403,
  'disk-full': 507,
  busy: 503,
  failed: 500,
} as const;
/** The code of an {@link ErrorResponse}. */
export type EditErrorCode = keyof typeof EDIT_ERRORS;

/** The zod schema of the response to a refused request. Nothing has changed on the disk. */
export const errorResponseSchema = z.strictObject({
  error: z.strictObject({
    code: z.enum(Object.keys(EDIT_ERRORS) as [EditErrorCode, ...EditErrorCode[]]),
    message: z.string().describe('What was expected and what was found.'),
    hint: z.string().describe('What to do.'),
    problems: z.array(problem).optional().describe('`invalid-level`: what is wrong with the text, and where.'),
    levels: z.array(refusedLevelSchema).optional().describe('`not-completable`: these levels.'),
    files: z
      .array(z.strictObject({ file: z.string().describe('Its path, for people.'), problems: z.array(problem) }))
      .optional()
      .describe('`not-published`: files that must be corrected first, and what is wrong with them.'),
    current: readResponseSchema
      .nullable()
      .optional()
      .describe('`conflict`: what is on the disk instead of the base; null: there is no such file any more.'),
  }),
});
/** The response to a refused request. */
export type ErrorResponse = z.infer<typeof errorResponseSchema>;
