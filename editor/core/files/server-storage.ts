import {
  DELETE_RESPONSE,
  type DeleteRequest,
  EDIT_API,
  EDIT_ERRORS,
  type EditEvent,
  ERROR_RESPONSE,
  isEditEvent,
  LIST_RESPONSE,
  ORDER_RESPONSE,
  type OrderRequest,
  PACK_RESPONSE,
  type PackRequest,
  PUBLISH_RESPONSE,
  type PublishRequest,
  READ_RESPONSE,
  type RenameRequest,
  type RestoreRequest,
  TRASH_RESPONSE,
  WRITE_RESPONSE,
  type WriteRequest,
} from '../../../schema/edit-api/index.ts';
import { fits, type Shape, type ValueOf } from '../../../schema/level/index.ts';
import { type Answer, type LevelStorage, type Link, storageError } from './level-storage.ts';
import type { PageKey } from './page-access.ts';
import { pageTimers, type Timers } from './timers.ts';

export interface ServerOptions {
  /** Where the page comes from, without a trailing slash. */
  readonly origin: string;
  /**
   * The token after `#token=` in the address that `gq edit` prints; '' if the page was opened without one: then errors say so.
   */
  readonly token: string;
  /** Lets the page in again after a restart. */
  readonly key: PageKey;
  /** A random name of this page. */
  readonly client: string;
  readonly fetch: typeof fetch;
  readonly timers?: Timers;
}

type Fields = Record<string, string>;

/** ms of silence after which the server counts as gone: two and a half heartbeats */
const SILENCE = EDIT_API.HEARTBEAT * 2500;
/** ms between attempts to reconnect; the last wait repeats */
const RETRIES = [250, 500, 1000, 2000, 5000] as const;

const UNREACHABLE = storageError(
  'unreachable',
  'the local server does not answer',
  'is gq edit still running? Start it again in the same folder and open the address it prints',
);

const OPEN_AGAIN = 'Open the address that gq edit printed last, or start gq edit again in the folder and open its new address';

const NO_TOKEN = storageError(
  'wrong-token',
  'this address lacks the key to the levels: only the full address that gq edit prints contains it, bookmarks and new tabs do not',
  OPEN_AGAIN,
);

/** The token of the run that the server is in, as far as it is known. */
interface Token {
  now(): string;
  /** @param refused the token that the server does not take. @returns whether there is another one now */
  renewed(refused: string): Promise<boolean>;
}

function tokenOf({ token, key }: Pick<ServerOptions, 'token' | 'key'>): Token {
  let now = token;
  let asking: Promise<string | null> | null = null;
  return {
    now: () => now,
    async renewed(refused) {
      if (now !== refused) return true;
      asking ??= key.renew();
      const fresh = await asking;
      asking = null;
      if (fresh !== null) now = fresh;
      return now !== refused;
    },
  };
}

/** The folder behind `gq edit`. */
export function createServerStorage(options: ServerOptions): LevelStorage {
  const { origin, client, fetch, timers = pageTimers } = options;
  const token = tokenOf(options);

  const ask = async <S extends Shape>(
    method: string,
    path: string,
    shape: S,
    headers: Fields,
    body?: object,
  ): Promise<Answer<ValueOf<S>>> => {
    const given = token.now();
    let response: Response;
    let value: unknown;
    try {
      response = await fetch(`${origin}${path}`, {
        method,
        headers: {
          [EDIT_API.TOKEN_HEADER]: given,
          ...(body === undefined ? {} : { 'Content-Type': 'application/json' }),
          ...headers,
        },
        body: body === undefined ? undefined : JSON.stringify(body),
        cache: 'no-store',
      });
      value = await response.json();
    } catch {
      return { ok: false, error: UNREACHABLE };
    }
    if (response.ok) {
      if (fits(value, shape)) return { ok: true, value };
    } else if (fits(value, ERROR_RESPONSE)) {
      const { code, message, hint, problems = [], current = null, ...lists } = value.error;
      if (code === 'wrong-token') {
        // nothing was done: the request is sent again
        if (await token.renewed(given)) return ask(method, path, shape, headers, body);
        return { ok: false, error: given === '' ? NO_TOKEN : storageError(code, message, OPEN_AGAIN) };
      }
      return { ok: false, error: { code, message, hint, problems, current, ...lists } };
    }
    const hint = 'are the page and gq edit of the same version? Reload the page';
    return {
      ok: false,
      error: storageError('unexpected', `the server gave an unexpected answer (${response.status})`, hint),
    };
  };
  const get = <S extends Shape>(path: string, shape: S) => ask('GET', path, shape, {});
  const post = <S extends Shape>(path: string, shape: S, body: object, headers: Fields = {}) =>
    ask('POST', path, shape, headers, body);
  const level = (id: string) => `${EDIT_API.LEVEL}?id=${encodeURIComponent(id)}`;
  const picked = async <T, U>(answer: Promise<Answer<T>>, pick: (value: T) => U): Promise<Answer<U>> => {
    const given = await answer;
    return given.ok ? { ok: true, value: pick(given.value) } : given;
  };

  return {
    kind: 'server',
    lasts: true,
    list: () => get(EDIT_API.LEVELS, LIST_RESPONSE),
    read: (id) => get(level(id), READ_RESPONSE),
    write(id, text, base) {
      const headers: Fields = base === null ? { 'If-None-Match': '*' } : { 'If-Match': base };
      const body: WriteRequest = { text, client };
      return picked(ask('PUT', level(id), WRITE_RESPONSE, headers, body), ({ entry }) => entry);
    },
    rename(id, to, base) {
      const body: RenameRequest = { id, to, client };
      return picked(post(EDIT_API.RENAME, WRITE_RESPONSE, body, { 'If-Match': base }), ({ entry }) => entry);
    },
    duplicate(id, to, base) {
      const body: RenameRequest = { id, to, client };
      return picked(post(EDIT_API.DUPLICATE, WRITE_RESPONSE, body, { 'If-Match': base }), ({ entry }) => entry);
    },
    remove(id, base) {
      const body: DeleteRequest = { id, client };
      return post(EDIT_API.DELETE, DELETE_RESPONSE, body, { 'If-Match': base });
    },
    trash: () => picked(get(EDIT_API.TRASH, TRASH_RESPONSE), ({ trash }) => trash),
    restore(trash, to) {
      const body: RestoreRequest = { trash, client, ...(to === undefined ? {} : { to }) };
      return picked(post(EDIT_API.RESTORE, WRITE_RESPONSE, body), ({ entry }) => entry);
    },
    order(folder, ids) {
      const body: OrderRequest = { folder, ids: [...ids], client };
      return post(EDIT_API.ORDER, ORDER_RESPONSE, body);
    },
    writePack(text, base) {
      const headers: Fields = base === null ? { 'If-None-Match': '*' } : { 'If-Match': base };
      const body: PackRequest = { text, client };
      return picked(ask('PUT', EDIT_API.PACK, PACK_RESPONSE, headers, body), ({ pack }) => pack);
    },
    publish(wanted) {
      const body: PublishRequest = { ...wanted, client };
      return post(EDIT_API.PUBLISH, PUBLISH_RESPONSE, body);
    },
    watch(onEvent, onLink) {
      // without a token, the server reports nothing
      if (token.now() === '') return () => {};
      const own = (event: EditEvent) => 'by' in event && event.by === client;
      return followEvents({ ...options, timers, token }, (event) => !own(event) && onEvent(event), onLink);
    },
  };
}

interface Following extends Pick<ServerOptions, 'origin' | 'key' | 'fetch'> {
  readonly timers: Timers;
  readonly token: Token;
}

/** Keeps a stream of events open and reconnects when it ends. */
function followEvents(
  { origin, token, key, fetch, timers }: Following,
  onEvent: (event: EditEvent) => void,
  onLink: (link: Link) => void,
): () => void {
  let isOver = false;
  let attempts = 0;
  let reported: Link | null = null;
  let abort = new AbortController();
  let cancelWait = () => {};

  const tell = (now: Link) => {
    if (now !== reported && !isOver) onLink(now);
    reported = now;
  };
  /** Settles when the stream ends. */
  const readAll = async (): Promise<void> => {
    abort = new AbortController();
    const { signal } = abort;
    const given = token.now();
    const response = await fetch(`${origin}${EDIT_API.EVENTS}`, {
      headers: { [EDIT_API.TOKEN_HEADER]: given },
      signal,
      cache: 'no-store',
    });
    if (response.status === EDIT_ERRORS['wrong-token']) {
      if (await token.renewed(given)) attempts = 0;
      else tell('otherRun');
    }
    if (!response.ok || response.body === null) throw new Error(`the server answered ${response.status}`);
    tell('up');
    void key.learn(given);
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let rest = '';
    let cancelSilence = timers.after(SILENCE, () => abort.abort());
    try {
      for (;;) {
        const { value, done } = await reader.read();
        if (done) return;
        // the connection works, so the next failure is the first one again
        attempts = 0;
        cancelSilence();
        cancelSilence = timers.after(SILENCE, () => abort.abort());
        const blocks = (rest + value).split('\n\n');
        rest = blocks.pop() ?? '';
        for (const block of blocks) for (const event of eventsOf(block)) onEvent(event);
      }
    } finally {
      cancelSilence();
    }
  };
  const goOn = () => {
    void readAll()
      .catch(() => undefined)
      .then(() => {
        if (isOver) return;
        if (reported !== 'otherRun') tell('gone');
        cancelWait = timers.after(RETRIES[Math.min(attempts++, RETRIES.length - 1)], goOn);
      });
  };
  goOn();
  return () => {
    isOver = true;
    cancelWait();
    abort.abort();
  };
}

/** The events of one block of an event stream; those that are not understood are skipped. */
function eventsOf(block: string): EditEvent[] {
  const data = block
    .split('\n')
    .filter((line) => line.startsWith('data:'))
    .map((line) => line.slice(5).trimStart())
    .join('\n');
  if (data === '') return [];
  try {
    const event: unknown = JSON.parse(data);
    return isEditEvent(event) ? [event] : [];
  } catch {
    return [];
  }
}
