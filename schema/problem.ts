import type { ProblemCode } from './codes.ts';

/** More problems than this are counted, not shown. */
export const MAX_PROBLEMS = 20;

/** Finding stops here: a file with so many problems is another kind of file. */
export const MAX_FINDINGS = 1000;

/** Something that keeps a file from being read, and what to do about it. */
export interface Problem {
  /** One of `CODES`. */
  readonly code: string;
  readonly severity: 'error' | 'warning';
  /** What was expected and what was found, one line, without the place. */
  readonly message: string;
  /** What to do, one line. */
  readonly hint: string;
  /** JSON pointer of the value it is about; '' = the whole file. For a missing key: the object that lacks it. */
  readonly pointer: string;
  /** 1-based; null where there is no text to point into. */
  readonly line: number | null;
  /** 1-based, in UTF-16 code units as editors count; null where there is no text to point into. */
  readonly column: number | null;
}

/** Keys and indices from the root of a JSON document to a value in it. */
export type Path = readonly (string | number)[];

/** A problem before its place in the text is known. */
export interface Finding {
  readonly code: ProblemCode;
  readonly message: string;
  readonly hint: string;
  readonly path: Path;
  /** Whether to point at the value or at the key before it. */
  readonly part: 'value' | 'key';
  /** Where in the text, when the finder knows better than the path. */
  readonly offset?: number;
}

/** JSON pointer (RFC 6901) of a path. */
export function toPointer(path: Path): string {
  return path.map((step) => `/${String(step).replaceAll('~', '~0').replaceAll('/', '~1')}`).join('');
}

/** Keys and indices of a JSON pointer; indices stay text. */
export function fromPointer(pointer: string): string[] {
  return pointer
    .split('/')
    .slice(1)
    .map((step) => step.replaceAll('~1', '/').replaceAll('~0', '~'));
}

/** A path as people write it: `asteroids[3].radius`; '' for the root. */
export function toWords(path: Path): string {
  let words = '';
  for (const step of path) {
    if (typeof step === 'number') words += `[${step}]`;
    else if (!/^[\w$-]+$/.test(step)) words += `[${JSON.stringify(step)}]`;
    else words += words === '' ? step : `.${step}`;
  }
  return words;
}
