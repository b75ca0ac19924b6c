/** The text of some bytes, and the first byte that is not UTF-8. */
export interface DecodedText {
  /** The text; bytes that are not UTF-8 become U+FFFD. */
  readonly text: string;
  /** `at` counts bytes; `offset` is the place in `text`. */
  readonly bad: { readonly byte: number; readonly at: number; readonly offset: number } | null;
}

// more arguments than this overflow the stack of some engines
const CHUNK = 8192;

function unitsToText(units: Uint8Array | Uint16Array, length: number): string {
  let text = '';
  for (let i = 0; i < length; i += CHUNK) {
    // apply accepts any array-like, but its type only accepts arrays
    text += String.fromCharCode.apply(null, units.subarray(i, Math.min(i + CHUNK, length)) as unknown as number[]);
  }
  return text;
}

/** The number of bytes that follow the first byte of a sequence, or -1 if no sequence begins with it. */
function followers(byte: number): number {
  if (byte >= 0xc2 && byte <= 0xdf) return 1;
  if (byte >= 0xe0 && byte <= 0xef) return 2;
  if (byte >= 0xf0 && byte <= 0xf4) return 3;
  return -1;
}

/**
 * The code point of the sequence of `count` + 1 bytes at `i`, or -1 if it is cut short, overlong, a surrogate or above
 * U+10FFFF.
 */
function codePointAt(bytes: Uint8Array, i: number, count: number): number {
  if (count < 0 || i + count >= bytes.length) return -1;
  let point = bytes[i] & (0x3f >> count);
  for (let k = 1; k <= count; k++) {
    const next = bytes[i + k];
    if ((next & 0xc0) !== 0x80) return -1;
    point = (point << 6) | (next & 0x3f);
  }
  if (count === 2 && (point < 0x800 || (point >= 0xd800 && point <= 0xdfff))) return -1;
  if (count === 3 && (point < 0x10000 || point > 0x10ffff)) return -1;
  return point;
}

/** Decodes UTF-8 strictly (RFC 3629): no overlong forms, no surrogates. A byte order mark is decoded like any character. */
export function decodeUtf8(bytes: Uint8Array): DecodedText {
  const length = bytes.length;
  let i = 0;
  while (i < length && bytes[i] < 0x80) i++;
  if (i === length) return { text: unitsToText(bytes, length), bad: null };

  // no sequence has more UTF-16 units than bytes
  const units = new Uint16Array(length);
  units.set(bytes.subarray(0, i));
  let n = i;
  let bad: DecodedText['bad'] = null;
  while (i < length) {
    const byte = bytes[i];
    if (byte < 0x80) {
      units[n++] = byte;
      i++;
      continue;
    }
    const count = followers(byte);
    const point = codePointAt(bytes, i, count);
    if (point < 0) {
      bad ??= { byte, at: i, offset: n };
      units[n++] = 0xfffd;
      i++;
      continue;
    }
    if (point < 0x10000) {
      units[n++] = point;
    } else {
      units[n++] = 0xd800 + ((point - 0x10000) >> 10);
      units[n++] = 0xdc00 + ((point - 0x10000) & 0x3ff);
    }
    i += count + 1;
  }
  return { text: unitsToText(units, n), bad };
}
