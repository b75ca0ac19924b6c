/** What a link says about a level: its text as a level file, not yet read; or why it can't be unpacked. */
export type LinkedText = { readonly ok: true; readonly text: string } | { readonly ok: false; readonly message: string };

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

/**
 * Packs the text of a level file for the fragment of a link, which no server sees. The editor and the game read the same links.
 *
 * @param text a level file as JSON; on one line it is shorter
 * @returns `level=` and the text, compressed (raw DEFLATE, base64url)
 */
export async function levelFragment(text: string): Promise<string> {
  const packed = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
  return KEY + toBase64Url(packed);
}

/**
 * Unpacks the text of a level file from the fragment of a link. It is text of a stranger: read it with `readLevel`.
 *
 * @param fragment such as `location.hash`, with or without its `#`; other parts, separated by `&`, are left alone
 * @returns null if the fragment has no level
 */
export async function levelTextOf(fragment: string): Promise<LinkedText | null> {
  const found = fragment
    .replace(/^#/, '')
    .split('&')
    .find((part) => part.startsWith(KEY));
  if (found === undefined) return null;
  try {
    const bytes = await through(fromBase64Url(found.slice(KEY.length)), new DecompressionStream('deflate-raw'));
    return { ok: true, text: new TextDecoder('utf-8', { fatal: true }).decode(bytes) };
  } catch {
    return { ok: false, message: 'the level in this link is damaged: the link was cut off or changed' };
  }
}
