import type { AccuracyName } from '../engine/index.ts';
import type { Goal } from '../solver/index.ts';
import { atLeast, atMost, figure, optionValue, publish, spread } from './harness.ts';
import { askedLevels } from './levels.ts';
import { type TimedSearch, timeSearch } from './timed-search.ts';

// measures the time to a first run of each level, over seeds; `--originals FILE` for the original's levels instead of the
// shipped ones

const SEEDS = Number(optionValue('--seeds') ?? 20);
const MINERAL_SEEDS = Number(optionValue('--mineral-seeds') ?? 3);
const REPEATS = 3;
/** A search that takes longer than this counts as failed, ms. */
const MOST = 5000;
const WARM_UP_SEEDS = 6;

const ANY: Goal = { minerals: 'any' };
const ALL: Goal = { minerals: 'all' };

const file = optionValue('--originals');
const levels = askedLevels();

/** One search for each accuracy, level and seed, in turns: a short disturbance of the machine affects all of them. */
function timeAll(
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

// warms the code up before anything counts
timeAll(['arcade', 'precise'], ANY, WARM_UP_SEEDS, 1000, 1);

const [arcade, precise] = timeAll(['arcade', 'precise'], ANY, SEEDS, 1, REPEATS);
const [minerals] = timeAll(['arcade'], ALL, MINERAL_SEEDS, 1, 1);

const msOf = (times: readonly TimedSearch[]) => times.map(({ ms, found }) => (found ? ms : Number.POSITIVE_INFINITY));
const ticksOf = (times: readonly TimedSearch[]) => times.map(({ ticks, found }) => (found ? ticks : Number.POSITIVE_INFINITY));
const median = (values: readonly number[]) => spread(values).median;
const worst = (values: readonly number[]) => Math.max(...values);
/** Whether no seed found a run with all minerals, so that perhaps there is none. */
const isOpen = (times: readonly TimedSearch[]) => times.every(({ found }) => !found);
const rate = (times: readonly TimedSearch[]) =>
  times.reduce((sum, { ticks }) => sum + ticks, 0) / times.reduce((sum, { ms }) => sum + ms, 0) / 1000;

const columns = [
  'level',
  'arcade median ms',
  'worst',
  'ticks',
  'presses',
  'precise median ms',
  'worst',
  'ticks',
  'all minerals median ms',
  'worst',
];
const rows = levels.map(({ name, level }, i) => [
  name,
  median(msOf(arcade[i])),
  worst(msOf(arcade[i])),
  median(arcade[i].map(({ ticks }) => ticks)),
  median(arcade[i].map(({ presses }) => presses)),
  median(msOf(precise[i])),
  worst(msOf(precise[i])),
  median(precise[i].map(({ ticks }) => ticks)),
  level.minerals.length === 0 || isOpen(minerals[i]) ? null : median(msOf(minerals[i])),
  level.minerals.length === 0 || isOpen(minerals[i]) ? null : worst(msOf(minerals[i])),
]);

const open = levels.filter((_, i) => isOpen(minerals[i])).map(({ name }) => name);
const withMinerals = minerals.filter((times, i) => levels[i].level.minerals.length > 0 && !isOpen(times));

if (process.argv.includes('--markdown')) {
  const line = (cells: readonly (string | number | null)[]) =>
    `| ${cells.map((cell) => (typeof cell === 'number' ? figure(cell) : (cell ?? '-'))).join(' | ')} |`;
  console.log([line(columns), line(columns.map(() => '---')), ...rows.map(line)].join('\n'));
  console.log('');
}

publish({
  title: `Time to a first run: ${file === null ? 'the shipped levels' : "the original's levels"}, ${SEEDS} seeds each`,
  columns,
  rows,
  claims: [
    atMost('arcade: median over levels and seeds, ticks', median(ticksOf(arcade.flat())), 10_000),
    atMost('arcade: worst, ticks', worst(ticksOf(arcade.flat())), 1_000_000),
    atMost('precise: median, ticks', median(ticksOf(precise.flat())), 10_000),
    atMost('precise: worst, ticks', worst(ticksOf(precise.flat())), 2_000_000),
    atMost('all minerals: worst, ticks', worst(ticksOf(withMinerals.flat())), 10_000_000),
    atLeast('ticks a second of the whole search, precise / arcade', rate(precise.flat()) / rate(arcade.flat()), 1 / 3),
    atMost('levels without a run with all minerals', open.length, 0),
  ],
  notes: [
    `Processor time of a warm process, scene compiled before, search made within; the least of ${REPEATS} equal searches. One core.`,
    `Million ticks a second of the whole search: arcade ${figure(rate(arcade.flat()))}, precise ${figure(rate(precise.flat()))}, all minerals ${figure(rate(minerals.flat()))}.`,
    ...(open.length > 0 ? [`No run with all minerals within ${MOST} ms: ${open.join(', ')}.`] : []),
  ],
});
