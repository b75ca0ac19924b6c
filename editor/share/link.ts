import { formatLevel, type LevelFile, type Problem } from '../../schema/index.ts';
import { readText } from '../files/index.ts';

/** A link, or why there is none. */
export type Linking =
  | { readonly ok: true; readonly url: string }
  | { readonly ok: false; readonly message: string; readonly hint: string };

export type Linked =
  | { readonly ok: true; readonly file: LevelFile }
  | { readonly ok: false; readonly message: string; readonly problems: readonly Problem[] };

/** characters; mail and chat programs cut off longer links */
export const LONGEST_LINK = 8000;
/** bytes; a link must not make the page unpack more than a small level */
const MOST_BYTES = 1_000_000;
const KEY = 'level=';

function toBase64Url(bytes: Uint8Array): string {
  let text = '';
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '');
}

function fromBase64Url(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text.replaceAll('-', '+').replaceAll('_', '/'));
  return Uint8Array.from(binary, (letter) => letter.charCodeAt(0));
}

async function through(bytes: Uint8Array<ArrayBuffer>, transform: CompressionStream | DecompressionStream): Promise<Uint8Array> {
  const reader = new Blob([bytes]).stream().pipeThrough(transform).getReader();
  const chunks: Uint8Array[] = [];
  let length = 0;
  for (;;) {
    const { value, done } = await reader.read();
    if (done) break;
    length += value.length;
    if (length > MOST_BYTES) {
      await reader.cancel();
      throw new RangeError('too long');
    }
    chunks.push(value);
  }
  const all = new Uint8Array(length);
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}

/** A link that contains a level in its fragment, which no server sees. @param page URL of the page, without a fragment */
export async function linkTo(file: LevelFile, page: string): Promise<Linking> {
  // as one line the text is shorter, and it reads back the same
  const text = JSON.stringify(JSON.parse(formatLevel(file)));
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  const url = `${page}#${KEY}${toBase64Url(packed)}`;
  if (url.length <= LONGEST_LINK) return { ok: true, url };
  const message = `the link would have ${url.length} characters, but mail and chat programs cut off links of more than ${LONGEST_LINK}`;
  return { ok: false, message, hint: 'download the level and send the file, or delete runs that are not needed' };
}

/** The level in a fragment such as `#level=...`; null if there is none. */
export async function levelOf(fragment: string): Promise<Linked | null> {
  const found = fragment
    .replace(/^#/, '')
    .split('&')
    .find((part) => part.startsWith(KEY));
  if (found === undefined) return null;
  let text: string;
  try {
    const bytes = await through(fromBase64Url(found.slice(KEY.length)), new DecompressionStream('deflate-raw'));
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    return { ok: false, message: 'the level in this link is damaged: the link was cut off or changed', problems: [] };
  }
  const reading = readText(text);
  if (reading.ok) return reading;
  return {
    ok: false,
    message: `the link contains no valid level: ${reading.problems[0].message}`,
    problems: reading.problems,
  };
}
