/** A small seeded generator of pseudo-random numbers (sfc32, by C. Doty-Humphrey): the same seed gives the same numbers everywhere. */
export interface Random {
  /** A whole number from 0 to 2^32 - 1. */
  next(): number;
  /** A number from 0 up to, not including, 1, in steps of 2^-32. */
  unit(): number;
  /** A whole number from 0 up to, not including, `n` (1 to 2^32). */
  below(n: number): number;
  /** A generator of its own that shares nothing with this one from here on. */
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
    // seeds that differ in one bit must have nothing in common by the first number given out
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

/** @param seed any finite number; all of its bits up to 2^53 count */
export function createRandom(seed: number): Random {
  return new Sfc32(seed, Math.floor(seed / 4294967296), Math.round((seed - Math.floor(seed)) * 4294967296));
}
