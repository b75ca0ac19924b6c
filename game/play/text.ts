import { PLAY_LIMITS } from './play.ts';

const DIGITS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_';
const VALUES: ReadonlyMap<string, number> = new Map([...DIGITS].map((digit, i) => [digit, i]));

/** Longer texts are no plays. */
const MOST_DIGITS = Math.ceil((PLAY_LIMITS.bytes * 8) / 6);

/**
 * Writes bytes as text for links and clipboards: base64url without padding, as RFC 4648 has it.
 *
 * @param bytes - the content of a `.gqr` file
 * @returns the text: letters, digits, `-` and `_`
 */
export function playToText(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 3) {
    const group = (bytes[i] << 16) | ((bytes[i + 1] ?? 0) << 8) | (bytes[i + 2] ?? 0);
    const digits = DIGITS[group >> 18] + DIGITS[(group >> 12) & 63] + DIGITS[(group >> 6) & 63] + DIGITS[group & 63];
    text += digits.slice(0, bytes.length - i + 1);
  }
  return text;
}

/**
 * Reads what {@link playToText} wrote. White space around it, as clipboards add it, doesn't count.
 *
 * @param text - the text
 * @returns the bytes; null if the text is not base64url, or longer than any play
 */
export function playFromText(text: string): Uint8Array | null {
  const digits = text.trim();
  if (digits.length % 4 === 1 || digits.length > MOST_DIGITS) return null;
  const bytes = new Uint8Array(Math.floor((digits.length * 6) / 8));
  let bits = 0;
  let count = 0;
  let at = 0;
  for (const digit of digits) {
    const value = VALUES.get(digit);
    if (value === undefined) return null;
    bits = ((bits << 6) | value) & 0xffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes[at++] = bits >> count;
  }
  // the bits that are left over are 0, so that bytes have one text
  return (bits & ((1 << count) - 1)) === 0 ? bytes : null;
}
