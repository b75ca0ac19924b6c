import { compile } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { createSearch, type Goal, verifyRun } from '../solver/index.ts';
import { type Chain, FAMILIES, LONGEST_RUN, makeChain, makeGrazing, makeMirrored } from '../tests/scenes/chains/index.ts';
import { atMost, define, number, numbers, oneOf } from './harness/index.ts';

// counts the ticks to a first run through chains of narrow doors; ticks are the same on every machine

/** The most doors of a chain with sharp turns that was ever built. */
const SHARPEST = 4;

/** A seed with which no short run grazes the hole by chance. */
const GRAZED = 3;

const SLICE = 1000;

/** Ticks to the first run; infinity if there is none within the budget. */
function ticksToRun(level: Level, goal: Goal, seed: number, budget: number): number {
  const search = createSearch(compile(level, 'precise'), { seed, goal, maxTicks: LONGEST_RUN });
  while (search.solutions.length === 0 && search.effort.ticks < budget) search.advance(SLICE);
  return search.solutions.length > 0 ? search.effort.ticks : Number.POSITIVE_INFINITY;
}

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

export const bench = define({
  what: 'ticks to a first run through chains of up to 12 narrow doors',
  options: {
    family: oneOf([...FAMILIES, 'grazing', 'mirrored'], null, 'only these chains'),
    doors: numbers([2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12], 'doors of the chains'),
    mirrored: numbers([1, 2, 3], 'doors of mirrored chains'),
    depths: numbers([1, 0.3, 0.1], 'px by which the grazed hole is touched'),
    seeds: number(3, 'seeds of each search'),
    budget: number(20_000_000, 'ticks of a search'),
  },
  claims: { missed: atMost(0, 'searches without a run') },
  run({ family: only, doors: sizes, mirrored, depths, seeds, budget }) {
    const rows: (string | number | null)[][] = [];
    const missed: Record<string, number> = {};
    const measure = (level: Level, goal: Goal = { minerals: 'any' }): number[] =>
      Array.from({ length: seeds }, (_, seed) => ticksToRun(level, goal, seed + 1, budget));
    /** Measures a level that `holds` complete, after a replay of them. */
    const measureBuilt = (family: string, size: number, { level, goal, holds }: Chain): void => {
      if (verifyRun(compile(level, 'precise'), holds, goal, LONGEST_RUN) === null) {
        throw new Error(`expected a completable level (${family}, ${size}), found one whose own run fails`);
      }
      const ticks = measure(level, goal);
      rows.push(rowOf(family, size, ticks));
      missed[family] = (missed[family] ?? 0) + ticks.filter((t) => t === Number.POSITIVE_INFINITY).length;
    };
    const isAsked = (family: string) => only === null || only === family;

    for (const family of FAMILIES.filter(isAsked)) {
      for (const doors of sizes) {
        if (family !== 'sharp turns' || doors <= SHARPEST) measureBuilt(family, doors, makeChain(family, doors, 1));
      }
    }
    if (isAsked('grazing')) for (const depth of depths) measureBuilt('grazing', depth, makeGrazing(depth, GRAZED));
    if (isAsked('mirrored')) {
      for (const doors of mirrored) rows.push(rowOf('mirrored (perhaps impossible)', doors, measure(makeMirrored(doors))));
    }
    return {
      title: `Ticks to a first run through chains of narrow doors, ${seeds} seeds each, precise, ${budget} ticks at most`,
      columns: ['family', 'doors, or depth in px', 'median', 'most of those found', 'not found'],
      rows,
      measured: { missed },
      notes: [`All levels are built around a run that is replayed first, except mirrored chains, which cannot go on for ever.`],
    };
  },
});
