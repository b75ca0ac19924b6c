import type { HttpBindings } from '@hono/node-server';
import type { Context } from 'hono';
import {
  CHALLENGE,
  deleteRequestSchema,
  EDIT_API,
  orderRequestSchema,
  packRequestSchema,
  publishRequestSchema,
  renameRequestSchema,
  restoreRequestSchema,
  writeRequestSchema,
} from '../../schema/index.ts';
import type { Access } from './access.ts';
import { createEventStreams } from './event-stream.ts';
import type { LevelFolder } from './level-folder.ts';
import type { Publish } from './publish.ts';
import { Refusal } from './refusal.ts';
import { baseOf, etagGiven, idOf, readBody } from './request.ts';

export type EditContext = Context<{ Bindings: HttpBindings }>;

/** Answers a request; may throw a `Refusal`. */
export type Answer = (c: EditContext, query: URLSearchParams) => Response | Promise<Response>;

/**
 * The answer function of each `METHOD /address` of `EDIT_API`.
 * @param port that the server listens on, once it does
 */
export function createApi(
  levels: LevelFolder,
  publish: Publish,
  access: Access,
  port: () => number,
): ReadonlyMap<string, Answer> {
  const streams = createEventStreams(levels.known);
  const { LEVELS, LEVEL, RENAME, DUPLICATE, DELETE, TRASH, RESTORE, ORDER, PACK, PUBLISH, EVENTS, KEY, RUN } = EDIT_API;

  const key: Answer = (c) => c.json({ key: access.key });

  const run: Answer = (c, query) => {
    const challenge = query.get('challenge') ?? '';
    if (!CHALLENGE.test(challenge))
      throw new Refusal('bad-request', 'expected a challenge of 22 to 64 letters, digits, _ and -', 'Reload the page.');
    return c.json(access.run(port(), challenge));
  };

  const list: Answer = async (c) => c.json(await levels.known.refresh());

  const read: Answer = (c, query) => {
    const level = levels.read(idOf(query));
    return c.json(level, 200, tagged(level.etag));
  };

  const write: Answer = async (c, query) => {
    const id = idOf(query);
    const base = baseOf(c.env.incoming);
    const { text, client } = await readBody(c.env.incoming, writeRequestSchema);
    refuseHalves(text);
    const { entry, created } = await levels.write(id, text, base, client);
    return c.json({ entry }, created ? 201 : 200, tagged(entry.etag));
  };

  const rename: Answer = async (c) => {
    const etag = etagGiven(c.env.incoming);
    const { id, to, client } = await readBody(c.env.incoming, renameRequestSchema);
    return c.json({ entry: await levels.rename(id, to, etag, client) });
  };

  const duplicate: Answer = async (c) => {
    const etag = etagGiven(c.env.incoming);
    const { id, to, client } = await readBody(c.env.incoming, renameRequestSchema);
    return c.json({ entry: await levels.duplicate(id, to, etag, client) }, 201);
  };

  const remove: Answer = async (c) => {
    const etag = etagGiven(c.env.incoming);
    const { id, client } = await readBody(c.env.incoming, deleteRequestSchema);
    return c.json(await levels.remove(id, etag, client));
  };

  const trash: Answer = (c) => c.json(levels.trash());

  const restore: Answer = async (c) => {
    const { trash: deleted, to, client } = await readBody(c.env.incoming, restoreRequestSchema);
    return c.json({ entry: await levels.restore(deleted, to, client) }, 201);
  };

  const order: Answer = async (c) => {
    const { folder, ids, client } = await readBody(c.env.incoming, orderRequestSchema);
    return c.json(await levels.order(folder, ids, client));
  };

  const pack: Answer = async (c) => {
    const base = baseOf(c.env.incoming);
    const { text, client } = await readBody(c.env.incoming, packRequestSchema);
    if (text !== null) refuseHalves(text);
    return c.json(await levels.writePack(text, base, client));
  };

  const makePage: Answer = async (c) => c.json(await publish(await readBody(c.env.incoming, publishRequestSchema)));

  const events: Answer = (c) => c.body(streams.open(), 200, { 'Content-Type': 'text/event-stream' });

  return new Map([
    [`GET ${LEVELS}`, list],
    [`GET ${LEVEL}`, read],
    [`PUT ${LEVEL}`, write],
    [`POST ${RENAME}`, rename],
    [`POST ${DUPLICATE}`, duplicate],
    [`POST ${DELETE}`, remove],
    [`GET ${TRASH}`, trash],
    [`POST ${RESTORE}`, restore],
    [`POST ${ORDER}`, order],
    [`PUT ${PACK}`, pack],
    [`POST ${PUBLISH}`, makePage],
    [`GET ${EVENTS}`, events],
    [`GET ${KEY}`, key],
    [`GET ${RUN}`, run],
  ]);
}

/** An unpaired surrogate would be stored as a different character. */
function refuseHalves(text: string): void {
  if (/\p{Surrogate}/u.test(text))
    throw new Refusal('bad-request', 'the text contains half of a character (a lone surrogate)', 'Send complete characters.');
}

const tagged = (etag: string | null): Record<string, string> => (etag === null ? {} : { ETag: etag });
