/**
 * A seeded generator of pseudo-random numbers (sfc32, by C. Doty-Humphrey). The same seed gives the same numbers on every
 * machine.
 */
export interface Random {
  /**
   * Draws a whole number.
   * @returns a whole number from 0 to 2^32 - 1, all equally likely
   */
  next(): number;
  /**
   * Draws a fraction.
   * @returns a number in [0, 1), a multiple of 2^-32
   */
  unit(): number;
  /**
   * Draws a whole number below a bound.
   * @param n the bound, a whole number from 1 to 2^32
   * @returns a whole number from 0 to `n` - 1
   */
  below(n: number): number;
  /**
   * Creates an independent generator, and advances this one by three numbers.
   * @returns a generator that shares no state with this one
   */
  fork(): Random;
}

class Sfc32 implements Random {
  private a: number;
  private b: number;
  private c: number;
  private counter = 1;

  constructor(a: number, b: number, c: number) {
    this.a = a | 0;
    this.b = b | 0;
    this.c = c | 0;
    // Warm up, so that seeds that differ in one bit give unrelated first numbers.
    for (let i = 0; i < 12; i++) this.next();
  }

  next(): number {
    const sum = (((this.a + this.b) | 0) + this.counter) | 0;
    this.counter = (this.counter + 1) | 0;
    this.a = this.b ^ (this.b >>> 9);
    this.b = (this.c + (this.c << 3)) | 0;
    this.c = (((this.c << 21) | (this.c >>> 11)) + sum) | 0;
    return sum >>> 0;
  }

  unit(): number {
    return this.next() / 4294967296;
  }

  below(n: number): number {
    return Math.floor(this.unit() * n);
  }

  fork(): Random {
    return new Sfc32(this.next(), this.next(), this.next());
  }
}

/**
 * Creates a generator.
 * @param seed any finite number; all of its bits up to 2^53 count, and fractions count too
 * @returns a generator at the start of its sequence
 */
export function createRandom(seed: number): Random {
  return new Sfc32(seed, Math.floor(seed / 4294967296), Math.round((seed - Math.floor(seed)) * 4294967296));
}
