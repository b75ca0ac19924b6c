import type { AccuracyName } from '../engine/index.ts';
import type { Goal } from '../solver/index.ts';
import { askedLevels, atLeast, atMost, define, figure, LEVELS, median, type NamedLevel, number, sum } from './harness/index.ts';
import { type TimedSearch, timeSearch } from './timed-search.ts';

const REPEATS = 3;
/** A search that takes longer than this counts as failed, ms. */
const MOST = 5000;
const WARM_UP_SEEDS = 6;

const ANY: Goal = { minerals: 'any' };
const ALL: Goal = { minerals: 'all' };

/** One search for each accuracy, level and seed, in turns: a short disturbance of the machine affects all of them. */
function timeAll(
  levels: readonly NamedLevel[],
  accuracies: readonly AccuracyName[],
  goal: Goal,
  seeds: number,
  from: number,
  repeats: number,
): TimedSearch[][][] {
  const times = accuracies.map(() => levels.map((): TimedSearch[] => []));
  for (let seed = from; seed < from + seeds; seed++) {
    for (const [i, { level }] of levels.entries()) {
      for (const [a, accuracy] of accuracies.entries()) times[a][i].push(timeSearch(level, accuracy, goal, seed, MOST, repeats));
    }
  }
  return times;
}

const msOf = (times: readonly TimedSearch[]) => times.map(({ ms, found }) => (found ? ms : Number.POSITIVE_INFINITY));
const ticksOf = (times: readonly TimedSearch[]) => times.map(({ ticks, found }) => (found ? ticks : Number.POSITIVE_INFINITY));
const worst = (values: readonly number[]) => Math.max(...values);
/** Whether no seed found a run with all minerals, so that perhaps there is none. */
const isOpen = (times: readonly TimedSearch[]) => times.every(({ found }) => !found);
const rate = (times: readonly TimedSearch[]) => sum(times.map(({ ticks }) => ticks)) / sum(times.map(({ ms }) => ms)) / 1000;

export const bench = define({
  what: 'time to a first run, with any minerals and with all',
  options: { ...LEVELS, seeds: number(20, 'seeds a level'), mineralSeeds: number(3, 'the same for all minerals') },
  claims: {
    arcade: atMost(10_000, 'arcade: median over levels and seeds, ticks'),
    arcadeWorst: atMost(1_000_000, 'arcade: worst, ticks'),
    precise: atMost(10_000, 'precise: median, ticks'),
    preciseWorst: atMost(2_000_000, 'precise: worst, ticks'),
    minerals: atMost(10_000_000, 'all minerals: worst, ticks'),
    rate: atLeast(1 / 3, 'ticks a second of the whole search, precise / arcade'),
    open: atMost(0, 'levels without a run with all minerals'),
  },
  run({ seeds, mineralSeeds, ...asked }) {
    const levels = askedLevels(asked);
    // warms the code up before anything counts
    timeAll(levels, ['arcade', 'precise'], ANY, WARM_UP_SEEDS, 1000, 1);
    const [arcade, precise] = timeAll(levels, ['arcade', 'precise'], ANY, seeds, 1, REPEATS);
    const [minerals] = timeAll(levels, ['arcade'], ALL, mineralSeeds, 1, 1);
    const open = levels.filter((_, i) => isOpen(minerals[i])).map(({ name }) => name);
    const withMinerals = minerals.filter((times, i) => levels[i].level.minerals.length > 0 && !isOpen(times));
    return {
      title: `Time to a first run: ${asked.originals === null ? 'the shipped levels' : "the original's levels"}, ${seeds} seeds each`,
      columns: [
        ...['level', 'arcade median ms', 'worst', 'ticks', 'presses', 'precise median ms', 'worst', 'ticks'],
        ...['all minerals median ms', 'worst'],
      ],
      rows: levels.map(({ name }, i) => [
        name,
        median(msOf(arcade[i])),
        worst(msOf(arcade[i])),
        median(arcade[i].map(({ ticks }) => ticks)),
        median(arcade[i].map(({ presses }) => presses)),
        median(msOf(precise[i])),
        worst(msOf(precise[i])),
        median(precise[i].map(({ ticks }) => ticks)),
        ...(withMinerals.includes(minerals[i]) ? [median(msOf(minerals[i])), worst(msOf(minerals[i]))] : [null, null]),
      ]),
      measured: {
        arcade: median(ticksOf(arcade.flat())),
        arcadeWorst: worst(ticksOf(arcade.flat())),
        precise: median(ticksOf(precise.flat())),
        preciseWorst: worst(ticksOf(precise.flat())),
        minerals: worst(ticksOf(withMinerals.flat())),
        rate: rate(precise.flat()) / rate(arcade.flat()),
        open: open.length,
      },
      notes: [
        `Processor time of a warm process, scene compiled before, search made within; the least of ${REPEATS} equal searches. One core.`,
        `Million ticks a second of the whole search: arcade ${figure(rate(arcade.flat()))}, precise ${figure(rate(precise.flat()))}, all minerals ${figure(rate(minerals.flat()))}.`,
        ...(open.length > 0 ? [`No run with all minerals within ${MOST} ms: ${open.join(', ')}.`] : []),
      ],
    };
  },
});
