/** Bytes at the begin or end of a line in which the id of a level must be. */
const NEAR = 1024;

const ID = String.raw`("(?:[^"\\]|\\.){0,200}"|-?\d{1,15})`;
const BEGIN = new RegExp(String.raw`^\s*\{\s*(?:"id"\s*:\s*${ID}\s*,\s*)?"level"\s*:\s*`, 's');
const END = new RegExp(String.raw`(?:,\s*"id"\s*:\s*${ID}\s*)?\}\s*$`, 's');

/** A level in a line, and the id that it has there. */
export interface Unwrapped {
  /** null: the line is a level, or gives it no id. */
  readonly id: string | null;
  readonly content: Uint8Array;
}

/**
 * Takes a level out of `{"id": ..., "level": {...}}`, byte by byte as it stands there. Any other line is taken for a level itself,
 * and so its reader says what is wrong with it.
 */
export function unwrap(line: Uint8Array): Unwrapped {
  const whole: Unwrapped = { id: null, content: line };
  const bytes = Buffer.from(line.buffer, line.byteOffset, line.length);
  // one character for each byte, so that places in the text are places in the bytes
  const begin = BEGIN.exec(bytes.toString('latin1', 0, NEAR));
  if (begin === null) return whole;
  const from = begin[0].length;
  const tail = Math.max(from, bytes.length - NEAR);
  const end = END.exec(bytes.toString('latin1', tail));
  if (end === null) return whole;
  const text = begin[1] ?? end[1];
  if (begin[1] !== undefined && end[1] !== undefined) return whole;
  const id = text === undefined ? null : idOf(text);
  return id === undefined ? whole : { id, content: line.subarray(from, tail + end.index) };
}

/** @param text the id as JSON; undefined if it is none, such as one with a tab or an unknown escape */
function idOf(text: string): string | undefined {
  try {
    return String(JSON.parse(Buffer.from(text, 'latin1').toString('utf8')));
  } catch {
    return undefined;
  }
}
