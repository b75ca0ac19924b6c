/** The task of a session, written by `bench/mutation.ts` for its child process. */
export interface Plan {
  /** Files to mutate, relative to the root of the repository. */
  readonly files: readonly string[];
  /** Test files of the room, cheap ones first. */
  readonly tests: readonly string[];
  /** The mutants to try; null: none, measure what each test reaches. */
  readonly mutants: readonly { readonly id: number; readonly isStatic: boolean }[] | null;
  /** File for the results, one line of JSON each. */
  readonly results: string;
  /** The measurement made before, if there are `mutants`. */
  readonly reach: Reach | null;
}

/** What each test takes and reaches; tests are identified by file and index. */
export interface Reach {
  readonly tests: readonly TestReach[];
}

export interface TestReach {
  readonly file: string;
  /** Its index in the file; -1 for what happens while the file is loaded. */
  readonly test: number;
  readonly ms: number;
  readonly reached: readonly number[];
  /** Whether it fails without a mutant, so that it shows nothing. */
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
