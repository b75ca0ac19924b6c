import { type Finding, formatValue, quote } from '../basics/index.ts';
import { BRACE } from './git-leftovers.ts';
import { isObject, type Json } from './values.ts';

/** Maps of a world that a message names. */
const MOST_NAMED = 5;

const DRAWN = 'circles and points whose class is a kind of object';

/** What a file of another editor is, and what to do with it. */
interface OtherFile {
  readonly found: string;
  readonly hint: string;
}

const PROJECT: OtherFile = { found: 'a project of Tiled', hint: 'It has no objects: import the maps (.tmj, .tmx) themselves.' };

/** Files that Tiled writes beside maps, by the type that their JSON says, and by their element in XML. */
const BESIDE_MAPS: Readonly<Record<string, OtherFile>> = {
  tileset: { found: 'a tileset of Tiled', hint: 'A level is made of the objects of a map: import the map (.tmj, .tmx).' },
  template: {
    found: 'a template of Tiled',
    hint: 'Choose Detach in the context menu of its instances in the map, save the map and import that.',
  },
};

function world({ maps }: Json): OtherFile {
  const names = (Array.isArray(maps) ? maps : []).flatMap((map) =>
    isObject(map) && typeof map.fileName === 'string' ? [quote(map.fileName)] : [],
  );
  const shown = names.slice(0, MOST_NAMED).join(', ');
  const more = names.length > MOST_NAMED ? ` and ${names.length - MOST_NAMED} more` : '';
  return names.length === 0
    ? { found: 'a world of Tiled, which names its maps by a pattern', hint: 'Import each of its maps by itself.' }
    : { found: `a world of Tiled, which has the maps ${shown}${more}`, hint: 'Import each of its maps by itself.' };
}

function ldtk(header: Json): OtherFile {
  const found = `${formatValue(header.fileType ?? 'LDtk').replace(/^the text /, '')}, a file of LDtk`;
  return {
    found,
    hint: `Turn on Tiled export in the project's settings, open the .tmx in Tiled, draw ${DRAWN} in place of its rectangles, and import that.`,
  };
}

function otherFile(value: unknown): OtherFile | null {
  if (!isObject(value)) return null;
  const header = value.__header__;
  if (isObject(header) && (header.app === 'LDtk' || String(header.fileType).startsWith('LDtk'))) return ldtk(header);
  if (value.type === 'world' || (Array.isArray(value.maps) && value.onlyShowAdjacentMaps !== undefined)) return world(value);
  if (typeof value.type === 'string' && Object.hasOwn(BESIDE_MAPS, value.type)) return BESIDE_MAPS[value.type];
  return Array.isArray(value.folders) && value.automappingRulesFile !== undefined ? PROJECT : null;
}

/**
 * Recognizes files of other level editors that hold no level that could be read.
 *
 * @param value - the JSON value of the file
 * @param expected - what was expected, in words
 * @returns what it is and what to do; null if it is none of them
 */
export function otherEditor(value: unknown, expected: string): Finding | null {
  const other = otherFile(value);
  if (other === null) return null;
  const { found, hint } = other;
  return { code: 'not-a-level', message: `expected ${expected}, found ${found}`, hint, path: [], part: 'value' };
}

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
  // nearly every file is an object: no other kind of file begins like one
  if ((typeof head === 'string' ? head.charCodeAt(0) : head[0]) === BRACE)
    return typeof head !== 'string' && isBinary(head) ? 'a binary file' : null;
  if (typeof head !== 'string') {
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
