import type { IncomingMessage } from 'node:http';
import type * as z from 'zod';
import { EDIT_API } from '../../schema/index.ts';
import type { Base } from './read-entry.ts';
import { Refusal } from './refusal.ts';

const LIMIT = EDIT_API.MAX_BODY_SIZE;

/**
 * Reads the body of a request and validates it by its schema.
 * @throws Refusal wrong-content-type, body-too-large, bad-request
 */
export async function readBody<T>(incoming: IncomingMessage, schema: z.ZodType<T>): Promise<T> {
  const { 'content-type': type, 'content-encoding': encoding, 'content-length': length } = incoming.headers;
  // the editor's page sends only JSON; forms of other sites can send only other types
  if (type !== 'application/json' || encoding !== undefined) {
    const found = encoding === undefined ? (type ?? 'none') : `${type ?? 'none'}, ${encoding}`;
    throw new Refusal(
      'wrong-content-type',
      `expected Content-Type: application/json alone, found ${found}`,
      'Send JSON without a Content-Encoding.',
    );
  }
  if (Number(length ?? 0) > LIMIT) throw tooLarge();
  let value: unknown;
  const bytes = await readAtMost(incoming);
  try {
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (error) {
    throw new Refusal('bad-request', `the body is not JSON in UTF-8: ${(error as Error).message}`, 'Send JSON.');
  }
  const parsed = schema.safeParse(value);
  if (!parsed.success) {
    const [issue] = parsed.error.issues;
    throw new Refusal(
      'bad-request',
      `the body: ${issue.path.join('.')}: ${issue.message}`,
      'Reload the page: it may come from another version of gq.',
    );
  }
  return parsed.data;
}

/** Reads a body, which may have no Content-Length, up to the limit. */
function readAtMost(incoming: IncomingMessage): Promise<Buffer> {
  return new Promise((resolve, reject) => {
    const pieces: Buffer[] = [];
    let total = 0;
    incoming.on('data', (piece: Buffer) => {
      total += piece.length;
      if (total > LIMIT) reject(tooLarge());
      else pieces.push(piece);
    });
    incoming.on('end', () => resolve(Buffer.concat(pieces)));
    const cutShort = () => reject(new Refusal('bad-request', 'the request ended in the middle of its body', 'Send it again.'));
    incoming.on('error', cutShort);
    incoming.on('close', cutShort);
  });
}

const tooLarge = (): Refusal =>
  new Refusal(
    'body-too-large',
    'a request may have at most 1 MiB; this one has more',
    'This editor cannot save a level with so many objects: edit the file with a text editor.',
  );

/** The `id` of a query, which must be its only parameter. @throws Refusal bad-request */
export function idOf(query: URLSearchParams): string {
  const [[key, id] = ['', '']] = query;
  if (query.size === 1 && key === 'id' && id !== '') return id;
  throw new Refusal(
    'bad-request',
    'expected one parameter, id',
    'Take the id from the list, encoded as encodeURIComponent does.',
  );
}

const STRONG_TAG = /^"[0-9a-f]{64}"$/;

/** What a change is based on. @throws Refusal base-missing, also for `If-Match: *`: unseen content is never overwritten */
export function baseOf({ headers }: IncomingMessage): Base {
  const { 'if-match': match, 'if-none-match': noneMatch } = headers;
  if (noneMatch === '*' && match === undefined) return 'no-file';
  if (noneMatch === undefined) return { etag: etagOf(match) };
  throw missing();
}

/** The etag that the file must have. @throws Refusal base-missing */
export const etagGiven = ({ headers }: IncomingMessage): string => etagOf(headers['if-match']);

function etagOf(match: string | undefined): string {
  if (match !== undefined && STRONG_TAG.test(match)) return match;
  throw missing();
}

const missing = (): Refusal =>
  new Refusal(
    'base-missing',
    'expected If-Match: with the etag of the content that the change was made from',
    'Send the etag exactly as it was received, with its quotes; for a new level send If-None-Match: * instead.',
  );
