import { compile } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { createSearch, type Goal, verifyRun } from '../solver/index.ts';
import { type Chain, FAMILIES, LONGEST_RUN, makeChain, makeGrazing, makeMirrored } from './chains/index.ts';
import { atMost, optionValue, publish } from './harness.ts';

// counts the ticks to a first run through chains of narrow doors; ticks are the same on every machine

const SEEDS = Number(optionValue('--seeds') ?? 3);
const MOST = Number(optionValue('--budget') ?? 20_000_000);
const DOORS = (optionValue('--doors') ?? '2,3,4,5,6,7,8,9,10,11,12').split(',').map(Number);
const MIRRORED = (optionValue('--mirrored') ?? '1,2,3').split(',').map(Number);
const DEPTHS = (optionValue('--depths') ?? '1,0.3,0.1').split(',').map(Number);
/** The most doors of a chain with sharp turns that was ever built. */
const SHARPEST = 4;

/** A seed with which no short run grazes the hole by chance. */
const GRAZED = 3;

const only = optionValue('--family');
const families = only === null ? FAMILIES : FAMILIES.filter((family) => family === only);

const SLICE = 1000;

/** Ticks to the first run; infinity if there is none within the budget. */
function ticksToRun(level: Level, goal: Goal, seed: number): number {
  const search = createSearch(compile(level, 'precise'), { seed, goal, maxTicks: LONGEST_RUN });
  while (search.solutions.length === 0 && search.effort.ticks < MOST) search.advance(SLICE);
  return search.solutions.length > 0 ? search.effort.ticks : Number.POSITIVE_INFINITY;
}

const measure = (level: Level, goal: Goal = { minerals: 'any' }): number[] =>
  Array.from({ length: SEEDS }, (_, seed) => ticksToRun(level, goal, seed + 1));

function rowOf(family: string, doors: number, ticks: readonly number[]): (string | number | null)[] {
  const found = ticks.filter(Number.isFinite);
  // the median counts a search without a run as one above all others
  const median = [...ticks].sort((a, b) => a - b)[(ticks.length - 1) >> 1];
  return [
    family,
    doors,
    Number.isFinite(median) ? median : null,
    found.length > 0 ? Math.max(...found) : null,
    ticks.length - found.length,
  ];
}

const rows: (string | number | null)[][] = [];
const missed = new Map<string, number>();

/** Measures a level that `holds` complete, after a replay of them. */
function measureBuilt(family: string, size: number, { level, goal, holds }: Chain): void {
  if (verifyRun(compile(level, 'precise'), holds, goal, LONGEST_RUN) === null) {
    throw new Error(`expected a completable level (${family}, ${size}), found one whose own run fails`);
  }
  const ticks = measure(level, goal);
  rows.push(rowOf(family, size, ticks));
  missed.set(family, (missed.get(family) ?? 0) + ticks.filter((t) => t === Number.POSITIVE_INFINITY).length);
}

for (const family of families) {
  for (const doors of DOORS) {
    if (family !== 'sharp turns' || doors <= SHARPEST) measureBuilt(family, doors, makeChain(family, doors, 1));
  }
}
if (only === null || only === 'grazing') for (const depth of DEPTHS) measureBuilt('grazing', depth, makeGrazing(depth, GRAZED));
if (only === null || only === 'mirrored') {
  for (const doors of MIRRORED) rows.push(rowOf('mirrored (perhaps impossible)', doors, measure(makeMirrored(doors))));
}

publish({
  title: `Ticks to a first run through chains of narrow doors, ${SEEDS} seeds each, precise`,
  columns: ['family', 'doors, or depth in px', 'median', 'most of those found', 'not found'],
  rows,
  claims: [...missed].map(([family, count]) => atMost(`${family}: searches without a run in ${MOST} ticks`, count, 0)),
  notes: [`All levels are built around a run that is replayed first, except mirrored chains, which cannot go on for ever.`],
});
