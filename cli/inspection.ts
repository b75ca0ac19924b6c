import type { Mode, Scene, Work } from '../engine/index.ts';
import { isVariant, KINDS, type Level, LISTED_KINDS, type ListedKind, listOf, type TermsReport } from '../schema/index.ts';
import type { ShownProblem } from './shown-problem.ts';

/** The results of `gq inspect` for a level. */
export interface Inspection {
  readonly file: string;
  /** The name of the level. */
  readonly level: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  readonly effects: Scene['effects'];
  readonly counts: Readonly<Record<string, number>>;
  /** How the time of the first run is spent; empty without a run. */
  readonly modes: readonly Mode[];
  /** The cost of the first run. */
  readonly work: Work;
  readonly problems: readonly ShownProblem[];
}

interface Counted {
  readonly key: string;
  readonly one: string;
  readonly many: string;
  count(level: Level): number;
}

/** Makes a key of words: `hot asteroids` becomes `hotAsteroids`. */
const keyOf = (words: string): string => words.replace(/ (.)/g, (_, letter: string) => letter.toUpperCase());

function countedOf(kind: ListedKind): Counted[] {
  const { one, many, counted: [countedOne, countedMany] = [one, many], variant } = KINDS[kind];
  const list = listOf(kind);
  const countIf = (varied: boolean) => (level: Level) => {
    const objects: readonly object[] = level[list];
    return objects.filter((object) => isVariant(kind, object) === varied).length;
  };
  const plain = {
    key: variant === undefined ? list : keyOf(countedMany),
    one: countedOne,
    many: countedMany,
    count: countIf(false),
  };
  if (variant === undefined) return [plain];
  return [plain, { key: keyOf(variant.many), one: variant.one, many: variant.many, count: countIf(true) }];
}

/** What is counted in a level: the objects of each kind, with variants apart, and the runs. */
export const COUNTED: readonly Counted[] = [
  ...LISTED_KINDS.flatMap(countedOf),
  { key: 'runs', one: 'run', many: 'runs', count: (level) => level.runs.length },
];

/** Counts everything in a level. */
export const countObjects = (level: Level): Record<string, number> =>
  Object.fromEntries(COUNTED.map(({ key, count }) => [key, count(level)]));
