/** What a session is to do, written by `bench/mutation.ts` for its child process. */
export interface Plan {
  /** files that are mutated, from the root of the repository */
  readonly files: readonly string[];
  /** test files of the room, cheap ones first */
  readonly tests: readonly string[];
  /** the mutants to try; null: measure what each test reaches, without any */
  readonly mutants: readonly { readonly id: number; readonly isStatic: boolean }[] | null;
  /** where results are written, a JSON a line */
  readonly results: string;
  /** what was measured before, for `mutants` */
  readonly reach: Reach | null;
}

/** What each test takes and reaches; tests by file and place in it. */
export interface Reach {
  readonly tests: readonly TestReach[];
}

export interface TestReach {
  readonly file: string;
  /** its place in the file; -1: what happens as the file is loaded */
  readonly test: number;
  readonly ms: number;
  readonly reached: readonly number[];
  /** fails without a mutant: it says nothing */
  readonly fails: boolean;
}

/** A line of results. */
export type Result =
  | { readonly kind: 'reach'; readonly reach: Reach }
  | { readonly kind: 'begun'; readonly id: number }
  | { readonly kind: 'tried'; readonly id: number; readonly fate: Fate; readonly by: string };

export type Fate = 'killed' | 'timeout' | 'survived' | 'unreached';

/** Environment variable with the path of the plan. */
export const PLAN = 'MUTATION_PLAN';
