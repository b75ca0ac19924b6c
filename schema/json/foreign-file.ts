import { BESIDE_MAPS } from './other-editors.ts';

/** First bytes of other kinds of files; null matches any byte. The first match counts. */
const BEGINNINGS: readonly (readonly [kind: string, bytes: readonly (number | null)[]])[] = [
  ['a PNG picture', [0x89, 0x50, 0x4e, 0x47]],
  ['a JPEG picture', [0xff, 0xd8, 0xff]],
  ['a GIF picture', letters('GIF8')],
  ['a WebP picture', [...letters('RIFF'), null, null, null, null, ...letters('WEBP')]],
  ['an AVIF picture', [null, null, null, null, ...letters('ftypavif')]],
  ['a HEIC picture', [null, null, null, null, ...letters('ftyphei')]],
  ['a video', [null, null, null, null, ...letters('ftyp')]],
  ['a video', [0x1a, 0x45, 0xdf, 0xa3]],
  ['a sound or a video', letters('RIFF')],
  ['a sound', letters('OggS')],
  ['a sound', letters('ID3')],
  ['a PDF document', letters('%PDF-')],
  ['a ZIP archive', [0x50, 0x4b, 0x03, 0x04]],
  ['a ZIP archive', [0x50, 0x4b, 0x05, 0x06]],
  ['a gzip archive', [0x1f, 0x8b]],
  ['a 7z archive', [0x37, 0x7a, 0xbc, 0xaf]],
  ['a RAR archive', letters('Rar!')],
];

function letters(text: string): number[] {
  return [...text].map((letter) => letter.charCodeAt(0));
}

const PAGE = 'an HTML page';
const ANSWER = 'the error of a server';
const MAP = 'a map of Tiled';

/** Kinds that a failed download leaves in place of a file. */
const FROM_SERVERS: readonly string[] = [PAGE, ANSWER];

/** What to do with a file of a kind that `foreignKind` names; null where only another file helps. */
export function hintForKind(kind: string): string | null {
  if (FROM_SERVERS.includes(kind)) return 'If it was downloaded, take the file itself: on GitHub it is behind "Raw".';
  if (kind === MAP) return 'gq import with its path and --out DIR makes a level of it.';
  return Object.values(BESIDE_MAPS).find(({ found }) => found === kind)?.hint ?? null;
}

/** Texts that are not JSON, by their first element. */
const ELEMENTS: Readonly<Record<string, string>> = {
  html: PAGE,
  head: PAGE,
  svg: 'an SVG picture',
  map: MAP,
  ...Object.fromEntries(Object.entries(BESIDE_MAPS).map(([name, { found }]) => [name, found])),
};

/** The kind of a text that is not JSON; null if it may be JSON. */
function kindOfText(text: string): string | null {
  const start = text.replace(/^(?:\ufeff|\u00ef\u00bb\u00bf)/, '').trimStart();
  if (/^<!doctype html/i.test(start)) return PAGE;
  if (/^[45]\d\d:? [a-z]/i.test(start)) return ANSWER;
  const element = xmlRoot(start)?.toLowerCase();
  if (element !== undefined && Object.hasOwn(ELEMENTS, element)) return ELEMENTS[element];
  return /^<\?xml/i.test(start) ? 'an XML file' : null;
}

/** Number of bytes that are examined. */
const HEAD = 1024;

/** `{` */
const BRACE = 0x7b;

/** NUL does not occur in text. UTF-16, a different mistake, has it in every other place. */
function isBinary(head: Uint8Array): boolean {
  const at = head.indexOf(0);
  return at > 1 || (at >= 0 && head.length > 3 && head[at + 1] === 0);
}

/**
 * Recognizes a file that is certainly not JSON by its first bytes.
 * @param source - the bytes of the file, or its text
 * @returns a name such as `a PNG picture`; null where it may be a text
 */
export function foreignKind(source: Uint8Array | string): string | null {
  const head = typeof source === 'string' ? source.slice(0, HEAD) : source.subarray(0, HEAD);
  if (typeof head !== 'string') {
    // nearly every file is an object: no other kind of file begins like one
    if (head[0] === BRACE) return isBinary(head) ? 'a binary file' : null;
    const found = BEGINNINGS.find(([, bytes]) => bytes.every((byte, i) => byte === null || head[i] === byte));
    if (found !== undefined) return found[0];
    if (!isUtf16(head) && isBinary(head)) return 'a binary file';
  }
  const text = typeof head === 'string' ? head : String.fromCharCode(...head);
  return kindOfText(text);
}

/** Whether the bytes begin with the byte order mark of UTF-16. */
export function isUtf16(bytes: Uint8Array): boolean {
  return (bytes[0] === 0xff && bytes[1] === 0xfe) || (bytes[0] === 0xfe && bytes[1] === 0xff);
}

/**
 * The order of the bytes in a text that is UTF-16 without a byte order mark; null if it is not. JSON begins with two characters
 * of ASCII, of which UTF-16 makes every other byte NUL.
 */
export function unmarkedUtf16(source: Uint8Array | string): 'little-endian' | 'big-endian' | null {
  if (typeof source === 'string' || source.length < 4) return null;
  const [a, b, c, d] = source;
  if (a !== 0 && b === 0 && c !== 0 && d === 0) return 'little-endian';
  return a === 0 && b !== 0 && c === 0 && d !== 0 ? 'big-endian' : null;
}

/** What may stand before the first element: white space, the declaration, instructions, comments and the type of the document. */
const PROLOG = /\s{1,100}|<\?[\s\S]*?\?>|<!--[\s\S]*?-->|<!DOCTYPE[^>[]*>/iy;

/** What git puts around a first element that it could not merge. */
const MARKER = /<{7,}[^\n]*\n/y;

const NAME = /<([a-z][\w:.-]*)/iy;

/**
 * The name of the first element of an XML text, as it is written there, whatever stands before it.
 *
 * @param text - the text, or its beginning, as far as the element
 * @returns null if no element comes first
 */
export function xmlRoot(text: string): string | null {
  let at = text.startsWith('\ufeff') ? 1 : 0;
  for (;;) {
    const skipped = [PROLOG, MARKER].find((pattern) => {
      pattern.lastIndex = at;
      return pattern.test(text);
    });
    if (skipped === undefined) break;
    at = skipped.lastIndex;
  }
  NAME.lastIndex = at;
  return NAME.exec(text)?.[1] ?? null;
}
