import { LONGEST_RUN, SHORTEST_RUN, VERDICTS } from '../basics/index.ts';
import { ACCURACY_NAMES } from '../config/index.ts';
import { fits, flag, listOf, object, oneOf, optional, orNull, RULES_SHAPE, text, type ValueOf } from '../level/index.ts';

// No zod: the page checks with these shapes what the server sends. `edit-schemas.ts` makes the zod schemas of them.

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

/** SHA-256 of the file's bytes, in quotes: as If-Match takes it. */
const etag = text(undefined, undefined, /^"[0-9a-f]{64}"$/);

/** Path of the file below the folder, with slashes, without .level.json: `07-slingshot`, `world-2/01-start`. */
const id = text(1, 4096);

/**
 * What each part of a new level's id must match: letters, digits, `_`, `-` and spaces, so that the file has the same name on
 * every system.
 */
export const LEVEL_ID_PART = /^(?!(?:con|prn|aux|nul|com\d|lpt\d)$)[a-z0-9](?:[a-z0-9 _-]{0,78}[a-z0-9_-])?$/i;

/** Random name of one page, so that it knows its own changes among the events. */
const client = text(undefined, undefined, /^[\w-]{1,64}$/);

const count = { type: 'integer', least: 0 } as const;
const positive = { type: 'integer', least: 1 } as const;
const many = <S extends Parameters<typeof listOf>[0]>(each: S) => listOf(each, Number.POSITIVE_INFINITY);

const problem = object({
  code: text(),
  severity: oneOf(['error', 'warning']),
  message: text(),
  hint: text(),
  pointer: text(),
  line: orNull(positive),
  column: orNull(positive),
});

export const LEVEL_ENTRY = object({
  id,
  /** Path of the file as `gq check` takes it, from where `gq edit` was started. */
  file: text(),
  /** null when the file could not be read. */
  etag: orNull(etag),
  status: oneOf(['valid', 'invalid', 'unreadable']),
  /** The level's name; null unless it is valid. */
  name: orNull(text()),
  /** Why it is not valid. */
  problems: many(problem),
  /** Why the editor may not write to it, for people; null when it may. */
  readOnly: orNull(text()),
});
/** A level in the folder. */
export type LevelEntry = ValueOf<typeof LEVEL_ENTRY>;

export const PACK_ON_DISK = object({
  /** Path of the file, for people. */
  file: text(),
  /** null when the file could not be read. */
  etag: orNull(etag),
  /** The file as it is, valid or not; null when it could not be read. */
  text: orNull(text()),
  /** Why the editor may not write to it, for people; null when it may. */
  readOnly: orNull(text()),
});
/** The folder's `pack.json`, the order in which its levels are played. */
export type PackOnDisk = ValueOf<typeof PACK_ON_DISK>;

export const FOLDER_TERMS = object({
  /** The configuration, as a person names it; null: there is none. */
  file: orNull(text()),
  /** How exactly levels are simulated. */
  accuracy: oneOf(ACCURACY_NAMES),
  /** The longest a run may last, s of simulated time. */
  maxTime: { type: 'number', least: SHORTEST_RUN, most: LONGEST_RUN } as const,
  /** The work that one level may cost, pieces of motion. */
  maxWork: positive,
  /** The rules of levels without their own: those that are not the game's. */
  rules: RULES_SHAPE,
  /** Why the configuration is not valid: the terms are then those of when it was. */
  problems: many(problem),
});
/**
 * The terms under which `gq check` judges the levels of the folder: those of the `gq.config.json` that it would use, and the
 * defaults for what that leaves out.
 */
export type FolderTerms = ValueOf<typeof FOLDER_TERMS>;

export const LIST_RESPONSE = object({
  folder: object({
    /** The same for the same folder in every run: what a page keeps for a folder, it keeps under this name. */
    id: text(),
    /** For people. */
    path: text(),
    /** What a new level directly in the folder says in `$schema`; null: nothing. */
    $schema: orNull(text()),
  }),
  /** '' and every folder below it that levels can be put into, with slashes. */
  folders: many(text()),
  /** By path, numbers by their value: the order of play, where no pack.json says another one. */
  levels: many(LEVEL_ENTRY),
  /** The pack.json of the folder; left out if there is none. */
  pack: optional(PACK_ON_DISK),
  terms: FOLDER_TERMS,
  /** What is wrong with the folder as a whole, for people; mostly nothing. */
  troubles: many(text()),
  /** Levels that are still to come, as events `read`; 0: these are all. */
  unread: count,
});
/** The response to `GET LEVELS`: the folder and its levels. */
export type ListResponse = ValueOf<typeof LIST_RESPONSE>;

export const READ_RESPONSE = object({
  ...LEVEL_ENTRY.keys,
  /** The file as it is, valid or not; null when it could not be read. */
  text: orNull(text()),
});
/** The response to `GET LEVEL`: a level with its text. */
export type ReadResponse = ValueOf<typeof READ_RESPONSE>;

export const WRITE_REQUEST = object({ text: text(), client });
/** The body of `PUT LEVEL`: the whole new text. It is stored unchanged, and only if it is a valid level. */
export type WriteRequest = ValueOf<typeof WRITE_REQUEST>;

export const WRITE_RESPONSE = object({ entry: LEVEL_ENTRY });
/** The response to every request that writes a level. */
export type WriteResponse = ValueOf<typeof WRITE_RESPONSE>;

export const RENAME_REQUEST = object({ id, to: id, client });
/**
 * The body of `POST RENAME` and `POST DUPLICATE`. `to` is the new id, in a folder that exists; its last part matches
 * `LEVEL_ID_PART`. The content of the file stays.
 */
export type RenameRequest = ValueOf<typeof RENAME_REQUEST>;

export const DELETE_REQUEST = object({ id, client });
/** The body of `POST DELETE`. */
export type DeleteRequest = ValueOf<typeof DELETE_REQUEST>;

export const TRASH_ENTRY = object({
  /** What `RESTORE` takes. */
  trash: text(),
  /** Its id before it was deleted. */
  id,
  /** When, ISO 8601. */
  deleted: text(),
});
/** A deleted level. Its file was moved below `.gq-trash` and stays there until somebody removes it by hand. */
export type TrashEntry = ValueOf<typeof TRASH_ENTRY>;

export const DELETE_RESPONSE = object({ trashed: TRASH_ENTRY });
/** The response to `POST DELETE`. */
export type DeleteResponse = ValueOf<typeof DELETE_RESPONSE>;

export const TRASH_RESPONSE = object({
  /** The last one deleted first. */
  trash: many(TRASH_ENTRY),
});
/** The response to `GET TRASH`: the deleted levels. */
export type TrashResponse = ValueOf<typeof TRASH_RESPONSE>;

export const RESTORE_REQUEST = object({ trash: text(1, 4200), to: optional(id), client });
/** The body of `POST RESTORE`. `to` is the id to restore it under; its old id when left out. */
export type RestoreRequest = ValueOf<typeof RESTORE_REQUEST>;

export const ORDER_REQUEST = object({ folder: text(undefined, 4096), ids: listOf(id, 100_000), client });
/**
 * The body of `POST ORDER`: all levels of one folder ('' is the outermost) in the wanted order. The files are renamed:
 * `07-slingshot` becomes `03-slingshot`.
 */
export type OrderRequest = ValueOf<typeof ORDER_REQUEST>;

export const ORDER_RESPONSE = object({
  renamed: many(object({ from: id, to: id })),
  /** All levels, as in `ListResponse`. */
  levels: many(LEVEL_ENTRY),
});
/** The response to `POST ORDER`. */
export type OrderResponse = ValueOf<typeof ORDER_RESPONSE>;

export const PACK_REQUEST = object({ text: orNull(text()), client });
/**
 * The body of `PUT PACK`: the whole new text of `pack.json`, which is stored unchanged, and only if it is valid; null: the file is
 * removed.
 */
export type PackRequest = ValueOf<typeof PACK_REQUEST>;

export const PACK_RESPONSE = object({ pack: orNull(PACK_ON_DISK) });
/** The response to `PUT PACK`: the file as it is now; null: there is none. */
export type PackResponse = ValueOf<typeof PACK_RESPONSE>;

export const PUBLISH_REQUEST = object({
  /** The name of the folder. */
  site: text(1, 80),
  /** This level alone; null: all levels. */
  level: orNull(id),
  title: text(1, 200),
  /** Whether the page has the runs of the levels, which give their solutions away. */
  withRuns: flag,
  /** Whether to publish levels that are not known to be completable. */
  force: flag,
  client,
});
/**
 * The body of `POST PUBLISH`: a static page with the levels, as `gq build` makes it, in a folder beside that of the levels. `site`
 * matches `LEVEL_ID_PART`; the folder is new, empty, or of an earlier build.
 */
export type PublishRequest = ValueOf<typeof PUBLISH_REQUEST>;

export const PUBLISH_RESPONSE = object({
  /** Path of the folder, for people. */
  site: text(),
  /** The number of levels on the page. */
  levels: positive,
  bytes: positive,
});
/** The response to `POST PUBLISH`. */
export type PublishResponse = ValueOf<typeof PUBLISH_RESPONSE>;

export const REFUSED_LEVEL = object({
  id,
  name: text(),
  verdict: oneOf(VERDICTS),
  /** What is wrong with it. */
  message: text(),
});
/** A level that is not published as it is. */
export type RefusedLevel = ValueOf<typeof REFUSED_LEVEL>;

/** The response to `GET KEY`. */
export const KEY_RESPONSE = object({ key: text(undefined, undefined, /^[\w-]{43}$/) });

/** The response to `GET RUN`. */
export const RUN_RESPONSE = object({
  /** Of this run. */
  nonce: text(undefined, undefined, /^[\w-]{22}$/),
  /** The HMAC of {@link runMessage}: the server has the key. */
  proof: text(undefined, undefined, /^[\w-]{43}$/),
});

/** What a page sends to `GET RUN` as `challenge`: random, so that no earlier answer fits. */
export const CHALLENGE = /^[\w-]{22,64}$/;

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

/** Who did it: null for another program. */
const by = orNull(client);

const event = <T extends string, K extends Parameters<typeof object>[0]>(type: T, keys: K) =>
  object({ type: { type: 'string', only: type } as const, ...keys });

/** What the server sends unasked, by its type. */
export const EDIT_EVENTS = {
  /** Comes first, and again whenever everything may have changed. */
  list: event('list', { list: LIST_RESPONSE }),
  /** More of a list that came without them, since they are many, or are only now read. */
  read: event('read', { levels: many(LEVEL_ENTRY), unread: count }),
  /** New, or with another content. */
  changed: event('changed', { entry: LEVEL_ENTRY, by }),
  removed: event('removed', { id, by }),
  /** The configuration has changed. */
  terms: event('terms', { terms: FOLDER_TERMS }),
  renamed: event('renamed', { from: id, entry: LEVEL_ENTRY, by }),
  /** The pack.json of the folder has changed; null: it is gone. */
  pack: event('pack', { pack: orNull(PACK_ON_DISK), by }),
} as const;
/** An event that the server sends unasked. */
export type EditEvent = { [T in keyof typeof EDIT_EVENTS]: ValueOf<(typeof EDIT_EVENTS)[T]> }[keyof typeof EDIT_EVENTS];

/** Whether a JSON value is an event of the server. */
export function isEditEvent(value: unknown): value is EditEvent {
  const type = (value as { readonly type?: unknown } | null)?.type;
  return Object.entries(EDIT_EVENTS).some(([name, shape]) => name === type && fits(value, shape));
}

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

export const ERROR_RESPONSE = object({
  error: object({
    code: oneOf(Object.keys(EDIT_ERRORS) as EditErrorCode[]),
    /** What was expected and what was found. */
    message: text(),
    /** What to do. */
    hint: text(),
    /** `invalid-level`: what is wrong with the text, and where. */
    problems: optional(many(problem)),
    /** `not-completable`: these levels. */
    levels: optional(many(REFUSED_LEVEL)),
    /** `not-published`: files that must be corrected first, by their path for people, and what is wrong with them. */
    files: optional(many(object({ file: text(), problems: many(problem) }))),
    /** `conflict`: what is on the disk instead of the base; null: there is no such file any more. */
    current: optional(orNull(READ_RESPONSE)),
  }),
});
/** The response to a refused request. Nothing has changed on the disk. */
export type ErrorResponse = ValueOf<typeof ERROR_RESPONSE>;
