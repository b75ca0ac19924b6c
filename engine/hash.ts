import type { RunEvent } from './simulation.ts';

const number = new Float64Array(1);
const halves = new Uint32Array(number.buffer);
// the processor decides which half of a double comes first; the hash must not depend on it
const LOW = new Uint8Array(new Uint32Array([1]).buffer)[0] === 1 ? 0 : 1;

/**
 * A hash of a sequence of doubles, bit for bit: two 32-bit lanes of multiplications and xors, with the constants and the finish
 * of murmur3. It is made to tell runs apart and to compare JavaScript engines, not for security.
 *
 * @example
 * ```ts
 * const hash = new Hash();
 * hash.add(0.1);
 * hash.addText('completed');
 * console.log(hash.digest()); // 16 hexadecimal digits
 * ```
 */
export class Hash {
  private a = 0x9747b28c;
  private b = 0x3c6ef372;

  /**
   * Adds a double.
   *
   * @param value - the double; every bit of it counts, so 0 and -0 differ
   */
  add(value: number): void {
    number[0] = value;
    const low = halves[LOW];
    const high = halves[1 - LOW];
    let a = Math.imul(this.a ^ Math.imul(low, 0xcc9e2d51), 0x1b873593);
    a = (a << 13) | (a >>> 19);
    let b = Math.imul(this.b ^ Math.imul(high, 0x85ebca6b), 0xc2b2ae35);
    b = (b << 15) | (b >>> 17);
    this.a = (Math.imul(a, 5) + b) | 0;
    this.b = (Math.imul(b, 5) + a) | 0;
  }

  /**
   * Adds a text.
   *
   * @param text - the text; its length counts, so that the parts of a sequence cannot shift
   */
  addText(text: string): void {
    this.add(text.length);
    for (let i = 0; i < text.length; i++) this.add(text.charCodeAt(i));
  }

  /**
   * Adds an event of a run: its type, its time to the last bit, and the objects that it names.
   *
   * @param event - the event
   */
  addEvent(event: RunEvent): void {
    this.addText(event.type);
    if (event.type === 'effect') this.addText(`${event.effect} ${event.what}`);
    this.add(event.time);
    if ('index' in event) this.add(event.index);
    if ('aliens' in event) for (const alien of event.aliens) this.add(alien);
    if ('with' in event && event.with !== null) {
      this.addText(event.with.kind);
      this.add(event.with.index);
    }
  }

  /**
   * Becomes a copy of another hash, which can then go on by itself.
   *
   * @param other - the hash to copy
   */
  copy(other: Hash): void {
    this.a = other.a;
    this.b = other.b;
  }

  /**
   * The hash of what was added so far. More may be added afterwards.
   *
   * @returns 16 hexadecimal digits
   */
  digest(): string {
    return finish(this.a ^ this.b) + finish(Math.imul(this.b, 0x9e3779b1) ^ this.a);
  }
}

function finish(h: number): string {
  let x = h;
  x = Math.imul(x ^ (x >>> 16), 0x85ebca6b);
  x = Math.imul(x ^ (x >>> 13), 0xc2b2ae35);
  return ((x ^ (x >>> 16)) >>> 0).toString(16).padStart(8, '0');
}
