import type { Mode, Scene, Work } from '../engine/index.ts';
import { isVariant, KINDS, type Level, LISTED_KINDS, type ListedKind, listOf } from '../schema/index.ts';
import type { ShownProblem } from './shown-problem.ts';

/** What `gq inspect` finds out about a level. */
export interface Inspection {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly effects: Scene['effects'];
  readonly counts: Readonly<Record<string, number>>;
  /** How the time of the first run is spent; empty without a run. */
  readonly modes: readonly Mode[];
  /** What the first run cost. */
  readonly work: Work;
  readonly problems: readonly ShownProblem[];
}

interface Counted {
  readonly key: string;
  readonly one: string;
  readonly many: string;
  count(level: Level): number;
}

/** `hot asteroids` as a key: `hotAsteroids` */
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

/** What is counted in a level: those of each kind and of its variant apart, and the runs. */
export const COUNTED: readonly Counted[] = [
  ...LISTED_KINDS.flatMap(countedOf),
  { key: 'runs', one: 'run', many: 'runs', count: (level) => level.runs.length },
];

/** How many of everything a level has. */
export const countObjects = (level: Level): Record<string, number> =>
  Object.fromEntries(COUNTED.map(({ key, count }) => [key, count(level)]));
