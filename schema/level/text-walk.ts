import type { RunTextPlace, RunTextReading } from './run-text.ts';
import { LINE_BREAK } from './shape.ts';

type Mistake = Extract<RunTextReading, { readonly ok: false }>;

class Stopped extends Error {
  constructor(readonly mistake: Mistake) {
    super(mistake.message);
  }
}

/** Letters of a word that are shown. */
const MOST_LETTERS = 20;

const WORD = /[\p{L}\p{N}_]+/uy;

/** Walks through a text from left to right, and knows the lines. */
export class TextWalk {
  at = 0;

  constructor(private readonly text: string) {}

  /** Runs a reader. @returns its result, or the mistake with which it stopped */
  static catching(read: () => RunTextReading): RunTextReading {
    try {
      return read();
    } catch (error) {
      if (error instanceof Stopped) return error.mistake;
      throw error;
    }
  }

  get isAtEnd(): boolean {
    return this.at >= this.text.length;
  }

  /** The next code unit; '' at the end. */
  get next(): string {
    return this.text.charAt(this.at);
  }

  /** Whether what is next matches. @param what sticky */
  sees(what: RegExp): boolean {
    what.lastIndex = this.at;
    return what.test(this.text);
  }

  /** Takes what is next. @param what a letter, or a sticky pattern @returns what was taken; null if something else is next */
  take(what: string | RegExp): string | null {
    if (typeof what === 'string') {
      if (!this.text.startsWith(what, this.at)) return null;
      this.at += what.length;
      return what;
    }
    what.lastIndex = this.at;
    const found = what.exec(this.text)?.[0];
    if (found === undefined) return null;
    this.at += found.length;
    return found;
  }

  /** Stops at what is next. */
  fail(expected: string, hint: string): never {
    return this.failAt(this.at, `${expected}, found ${this.found()}`, hint);
  }

  failAt(offset: number, message: string, hint: string): never {
    throw new Stopped({ ok: false, message, hint, ...this.places([offset])[0] });
  }

  /** The places of offsets, which must be in order. */
  places(offsets: readonly number[]): RunTextPlace[] {
    const breaks = new RegExp(LINE_BREAK.source, 'g');
    let line = 1;
    let start = 0;
    let next = breaks.exec(this.text);
    return offsets.map((offset) => {
      while (next !== null && next.index < offset) {
        line++;
        start = next.index + next[0].length;
        next = breaks.exec(this.text);
      }
      return { offset, line, column: offset - start + 1 };
    });
  }

  private found(): string {
    if (this.isAtEnd) return 'the end';
    if (this.sees(new RegExp(LINE_BREAK.source, 'y'))) return 'the end of the line';
    WORD.lastIndex = this.at;
    const word = WORD.exec(this.text)?.[0] ?? String.fromCodePoint(this.text.codePointAt(this.at) as number);
    const letters = [...word.slice(0, 2 * MOST_LETTERS)];
    return JSON.stringify(letters.length > MOST_LETTERS ? `${letters.slice(0, MOST_LETTERS).join('')}…` : word);
  }
}
