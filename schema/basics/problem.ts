import type { ProblemCode } from './adjustable.ts';

/** The verdicts on a level. All but the first need attention. */
export const VERDICTS = ['completable', 'broken', 'unproven', 'impossible', 'invalid', 'crashed'] as const;

/** The verdict on a level. */
export type Verdict = (typeof VERDICTS)[number];

/** At most this many problems are shown; the others are only counted. */
export const MAX_PROBLEMS = 20;

/** The search for problems stops here: a file with so many is not a level file with mistakes. */
export const MAX_FINDINGS = 1000;

/** A problem in a file, and what to do about it. An error keeps the file from being read. */
export interface Problem {
  /** The stable name of this kind of problem: one of {@link CODES}. */
  readonly code: string;
  /** Whether it keeps the file from being used. */
  readonly severity: 'error' | 'warning';
  /** What was expected and what was found, in one line, without the place. */
  readonly message: string;
  /** What to do about it, in one line. */
  readonly hint: string;
  /** JSON pointer of the value concerned; '' is the whole file. For a missing key: the object that lacks it. */
  readonly pointer: string;
  /** Line in the file, from 1; null if there is no text to point into. */
  readonly line: number | null;
  /** Column in the line, from 1, in UTF-16 code units as editors count; null if there is no text to point into. */
  readonly column: number | null;
}

/** Keys and indices that lead from the root of a JSON document to a value in it. */
export type Path = readonly (string | number)[];

/** A problem whose place in the text is not yet known. */
export interface Finding {
  readonly code: ProblemCode;
  readonly message: string;
  readonly hint: string;
  readonly path: Path;
  /** Whether the place is that of the value or of the key before it. */
  readonly part: 'value' | 'key';
  /** Offset in the text, where the finder knows it more exactly than the path says. */
  readonly offset?: number;
}

/** The JSON pointer (RFC 6901) of a path. */
export function toPointer(path: Path): string {
  return path.map((step) => `/${String(step).replaceAll('~', '~0').replaceAll('/', '~1')}`).join('');
}

/** The keys and indices of a JSON pointer; indices stay text. */
export function fromPointer(pointer: string): string[] {
  return pointer
    .split('/')
    .slice(1)
    .map((step) => step.replaceAll('~1', '/').replaceAll('~0', '~'));
}
