import { decodeUtf8 } from '../json/utf8.ts';

/** What stands before the value that a module exports. */
// a comment is matched with its line end: otherwise a line of slashes could be split in very many ways
const BEGINNING = /^(?:\s|\/\/[^\n]*\n|(['"])use strict\1;?)*(?:module\.exports\s*=|export\s+default\b)/;

/** The first bytes, in which a module says that it is one. */
const HEAD = 4096;

/** The text with everything that a pattern matches made blank; places stay. */
const blank = (text: string, pattern: RegExp): string => text.replace(pattern, (part) => part.replace(/[^\r\n]/g, ' '));

function textOf(source: Uint8Array | string): string | null {
  if (typeof source === 'string') return source;
  const head = decodeUtf8(source.subarray(0, HEAD)).text;
  if (!BEGINNING.test(head.replace(/^\ufeff/, ''))) return null;
  const { text, bad } = decodeUtf8(source);
  return bad === null ? text : null;
}

/** A JavaScript module whose exported value may be JSON. */
export interface ModuleText {
  /** Its text, without a byte order mark. */
  readonly text: string;
  /** The exported value at its place in the text; everything around it and lines of comment are blank. */
  readonly value: string;
}

/** Finds the value that a JavaScript module exports, if it exports only one; null if the source is no such module. */
export function readModule(source: Uint8Array | string): ModuleText | null {
  const text = textOf(source)?.replace(/^\ufeff/, '') ?? null;
  if (text === null || !BEGINNING.test(text)) return null;
  const value = blank(blank(blank(text, BEGINNING), /;\s*$/), /^[ \t]*\/\/.*$/gm);
  return { text, value };
}
