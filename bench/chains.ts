import { compile } from '../engine/index.ts';
import type { Level } from '../schema/index.ts';
import { createSearch, verifyRun } from '../solver/index.ts';
import { FAMILIES, LONGEST_RUN, makeChain, makeTurns } from './chains/index.ts';
import { atMost, optionValue, publish } from './harness.ts';

// counts the ticks to a first run through chains of narrow doors; ticks are the same on every machine

const SEEDS = Number(optionValue('--seeds') ?? 3);
const MOST = Number(optionValue('--budget') ?? 20_000_000);
const DOORS = (optionValue('--doors') ?? '2,3,4,5,6,7,8,9,10,11,12').split(',').map(Number);
const TURNS = (optionValue('--turns') ?? '1,2,3').split(',').map(Number);

const SLICE = 1000;

/** Ticks to the first run; infinity if there is none within the budget. */
function ticksToRun(level: Level, seed: number): number {
  const search = createSearch(compile(level, 'precise'), { seed, maxTicks: LONGEST_RUN });
  while (search.solutions.length === 0 && search.effort.ticks < MOST) search.advance(SLICE);
  return search.solutions.length > 0 ? search.effort.ticks : Number.POSITIVE_INFINITY;
}

const measure = (level: Level): number[] => Array.from({ length: SEEDS }, (_, seed) => ticksToRun(level, seed + 1));

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
for (const family of FAMILIES) {
  for (const doors of DOORS) {
    const { level, holds } = makeChain(family, doors, 1);
    if (verifyRun(compile(level, 'precise'), holds, { minerals: 'any' }, LONGEST_RUN) === null) {
      throw new Error(`expected a completable ${family} chain of ${doors} doors, found one whose own run fails`);
    }
    const ticks = measure(level);
    rows.push(rowOf(family, doors, ticks));
    missed.set(family, (missed.get(family) ?? 0) + ticks.filter((t) => t === Number.POSITIVE_INFINITY).length);
  }
}
for (const doors of TURNS) rows.push(rowOf('turns (perhaps impossible)', doors, measure(makeTurns(doors))));

publish({
  title: `Ticks to a first run through chains of narrow doors, ${SEEDS} seeds each, precise`,
  columns: ['family', 'doors', 'median', 'most of those found', 'not found'],
  rows,
  claims: FAMILIES.map((family) => atMost(`${family}: searches without a run in ${MOST} ticks`, missed.get(family) ?? 0, 0)),
  notes: [`Chains are built around a run that is replayed first, except turns, which nobody knows to be completable.`],
});
