import { writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { seeded } from '../tests/scenes/seeded.ts';
import {
  type Assumptions,
  drawFleet,
  drawSet,
  type Fleet,
  inWords,
  type LevelCosts,
  type Line,
  measureCosts,
  type Outcome,
  type Policy,
  type ShardCosts,
  type Split,
  simulateFleet,
  splitSet,
} from './fleet/index.ts';
import { atMost, optionValue, publish } from './harness.ts';

const PICTURE = fileURLToPath(new URL('../../docs/fleet-model.svg', import.meta.url));

/** Sets that are drawn, and fleets that do each of them. */
const SETS = Number(optionValue('--sets') ?? 10);
const FLEETS = 10;
const SHARDS = [10, 30, 100, 300, 1000, 3000, 10_000];
/** Those of the table. */
const SHOWN = [10, 100, 1000, 10_000];
const HOUR = 3600;

const assumptions: Assumptions = {
  levels: 10_000_000,
  measured: measureCosts(),
  fleet: {
    machines: 50,
    cores: 4,
    taskDeathsPerHour: 0.02,
    machineDeathsPerHour: 0.002,
    // SlurmdTimeout, unless somebody has set it
    detection: 300,
    restartDelay: 60,
    repair: 1800,
    stragglers: 0.02,
    slowdown: 4,
  },
  patience: 1.5,
};
const { levels, measured, fleet, patience } = assumptions;
const slots = fleet.machines * fleet.cores;
const NO_FAILURES: Fleet = { ...fleet, taskDeathsPerHour: 0, machineDeathsPerHour: 0, stragglers: 0 };

/** A fleet, and what is done about its failures. */
interface Case {
  readonly name: string;
  readonly dashes: string;
  readonly fleet: Fleet;
  readonly policy: Policy;
}

const AT_ONCE: Policy = { rerun: 'at once', patience: null };
const NONE: Case = { name: 'no failures', dashes: '', fleet: NO_FAILURES, policy: AT_ONCE };
const ROUNDS: Case = { name: 'rerun in rounds', dashes: '2 3', fleet, policy: { rerun: 'after the round', patience: null } };
const RERUN: Case = { name: 'rerun at once', dashes: '9 3 2 3', fleet, policy: AT_ONCE };
const COPIES: Case = { name: 'rerun, and copies', dashes: '6 4', fleet, policy: { rerun: 'at once', patience } };

/** What is done with the levels, how they are split, and on which fleets. */
interface Plan {
  readonly job: 'search' | 'replay';
  readonly split: Split;
  readonly cases: readonly Case[];
}

const PLANS: readonly Plan[] = [
  { job: 'search', split: 'rule', cases: [NONE, ROUNDS, RERUN, COPIES] },
  { job: 'search', split: '--costs', cases: [NONE, COPIES] },
  { job: 'replay', split: 'rule', cases: [NONE, ROUNDS, RERUN, COPIES] },
];

/** All simulations of one plan with one number of shards in one case. */
interface Cell {
  readonly plan: Plan;
  readonly shards: number;
  readonly case: Case;
  readonly outcomes: Outcome[];
  /** Of each set: the slowest shard over the mean. */
  readonly slowest: number[];
}

const cells: Cell[] = PLANS.flatMap((plan) =>
  SHARDS.flatMap((shards) => plan.cases.map((one): Cell => ({ plan, shards, case: one, outcomes: [], slowest: [] }))),
);

const sum = (values: Iterable<number>): number => {
  let total = 0;
  for (const value of values) total += value;
  return total;
};
const mean = (values: readonly number[]): number => sum(values) / values.length;
/** The value that so large a share of the values does not exceed. */
const quantile = (values: readonly number[], share: number): number =>
  values.toSorted((a, b) => a - b)[Math.ceil(share * values.length) - 1];

function slowestOverMean({ useful, overhead }: ShardCosts): number {
  const all = useful.map((cost, shard) => cost + overhead[shard]);
  return all.reduce((a, b) => Math.max(a, b)) / (sum(all) / all.length);
}

for (let seed = 0; seed < SETS; seed++) {
  for (const job of ['search', 'replay'] as const) {
    const set = drawSet(levels, measured[job], seeded(seed));
    for (const plan of PLANS.filter((one) => one.job === job)) {
      for (const shards of SHARDS) {
        const costs = splitSet(set, shards, plan.split, measured);
        for (const cell of cells.filter((one) => one.plan === plan && one.shards === shards)) {
          cell.slowest.push(slowestOverMean(costs));
          for (let i = 0; i < FLEETS; i++) {
            cell.outcomes.push(simulateFleet(costs, cell.case.fleet, cell.case.policy, seeded(1_000_000 + seed * FLEETS + i)));
          }
        }
      }
    }
  }
}

const cellOf = (job: Plan['job'], split: Split, shards: number, one: Case): Cell =>
  cells.find((cell) => cell.plan.job === job && cell.plan.split === split && cell.shards === shards && cell.case === one)!;
const hoursOf = ({ outcomes }: Cell): number => mean(outcomes.map(({ makespan }) => makespan)) / HOUR;
const p95Of = ({ outcomes }: Cell): number =>
  quantile(
    outcomes.map(({ makespan }) => makespan),
    0.95,
  ) / HOUR;
/** A part of the time of all slots, %. */
const shareOf = ({ outcomes }: Cell, of: 'useful' | 'overhead' | 'slow' | 'lost'): number =>
  100 * mean(outcomes.map((outcome) => outcome[of] / (slots * outcome.makespan)));

/** All work over all slots, h. */
const idealOf = (costs: LevelCosts): number => (levels * mean(costs)) / slots / HOUR;
const ideal = { search: idealOf(measured.search), replay: idealOf(measured.replay) };

const percentOver = (value: number, base: number): number => 100 * (value / base - 1);

/** How far equal shards without failures are from ceil(shards / slots) times the cost of one, as a share. */
function errorOfEqualShards(): number {
  const cost = 37.5;
  const equal = (shards: number): ShardCosts => ({
    useful: new Float64Array(shards).fill(cost),
    overhead: new Float64Array(shards),
  });
  return Math.max(
    ...SHARDS.map((shards) => {
      const { makespan } = simulateFleet(equal(shards), NO_FAILURES, AT_ONCE, seeded(0));
      return Math.abs(makespan / (Math.ceil(shards / slots) * cost) - 1);
    }),
  );
}

/** How far a shard that starts anew until it lives is from (e^(rate T) - 1) / rate, in standard errors. */
function errorOfRestarts(): number {
  const samples = 20_000;
  const rate = 0.5;
  const hours = 2;
  const grown = Math.exp(rate * hours);
  const standardError = Math.sqrt(grown ** 2 - 2 * rate * hours * grown - 1) / rate / Math.sqrt(samples);
  const one: ShardCosts = { useful: Float64Array.of(hours * HOUR), overhead: Float64Array.of(0) };
  const dying: Fleet = { ...NO_FAILURES, machines: 1, cores: 1, taskDeathsPerHour: rate, detection: 0, restartDelay: 0 };
  const random = seeded(1);
  const times = Array.from({ length: samples }, () => simulateFleet(one, dying, AT_ONCE, random).makespan / HOUR);
  return Math.abs(mean(times) - (grown - 1) / rate) / standardError;
}

const lineOf = (job: Plan['job'], one: Case): Line => ({
  name: one.name,
  dashes: one.dashes,
  points: SHARDS.map((shards) => ({ shards, hours: hoursOf(cellOf(job, 'rule', shards, one)) })),
});

const millions = `${levels / 1e6} million`;
writeFileSync(
  PICTURE,
  drawFleet(
    [
      {
        title: `${millions} searches`,
        lines: [NONE, RERUN, COPIES].map((one) => lineOf('search', one)),
        ideal: ideal.search,
      },
      {
        title: `${millions} replays`,
        lines: [NONE, RERUN, COPIES].map((one) => lineOf('replay', one)),
        ideal: ideal.replay,
      },
    ],
    `${fleet.machines} machines with ${fleet.cores} cores`,
  ),
);

const thousand = {
  none: cellOf('search', 'rule', 1000, NONE),
  rerun: cellOf('search', 'rule', 1000, RERUN),
  copies: cellOf('search', 'rule', 1000, COPIES),
};
const twice = cells.flatMap(({ outcomes }) => outcomes).filter(({ counted }) => counted.some((times) => times !== 1)).length;
const scans = (shards: number): number => (shards - 1) * levels * measured.scan;
const scanOver = (job: Plan['job']): number => scans(1000) / (levels * mean(measured[job]));
const best = (job: Plan['job'], one: Case): number =>
  SHARDS.reduce((a, b) => (hoursOf(cellOf(job, 'rule', b, one)) < hoursOf(cellOf(job, 'rule', a, one)) ? b : a));

publish({
  title: `${millions} levels on ${slots} cores, simulated: ${SETS} sets, ${FLEETS} fleets for each`,
  columns: [
    'job',
    'shards',
    'split',
    'failures',
    'h, mean',
    'h, p95',
    'efficiency %',
    'overhead %',
    'slow %',
    'lost %',
    'slowest / mean',
  ],
  rows: cells
    .filter(({ shards }) => SHOWN.includes(shards))
    .map((cell) => [
      cell.plan.job,
      cell.shards,
      cell.plan.split,
      cell.case.name,
      hoursOf(cell),
      p95Of(cell),
      shareOf(cell, 'useful'),
      shareOf(cell, 'overhead'),
      shareOf(cell, 'slow'),
      shareOf(cell, 'lost'),
      mean(cell.slowest),
    ]),
  claims: [
    atMost('equal shards without failures against ceil(shards / cores) x cost, relative error', errorOfEqualShards(), 1e-9),
    atMost('a shard that dies against (e^(rate T) - 1) / rate, standard errors', errorOfRestarts(), 4),
    atMost('simulations in which a shard was counted twice or never', twice, 0),
    atMost(
      '1,000 shards of searches with failures and copies, over the same without, %',
      percentOver(hoursOf(thousand.copies), hoursOf(thousand.none)),
      50,
    ),
    atMost('the same over the ideal, %', percentOver(hoursOf(thousand.copies), ideal.search), 75),
    atMost('the same, p95 over the ideal, %', percentOver(p95Of(thousand.copies), ideal.search), 95),
    atMost('the same with copies against without, time', hoursOf(thousand.copies) / hoursOf(thousand.rerun), 0.95),
  ],
  notes: [
    ...inWords(assumptions),
    `Ideal, all levels over all cores: ${ideal.search.toFixed(2)} h of searches, ${ideal.replay.toFixed(4)} h of replays. Besides, on one core: gq plan ${((levels * measured.plan) / HOUR).toFixed(2)} h, gq merge ${((levels * measured.merge) / HOUR).toFixed(2)} h.`,
    `Every shard reads the whole set. With 1,000 shards this costs ${scanOver('replay').toFixed(1)} times as much as all replays, and ${(100 * scanOver('search')).toFixed(0)} % of all searches. Of the numbers tried, ${best('search', COPIES)} shards are fastest for searches with failures and copies, ${best('replay', COPIES)} for replays.`,
    'Efficiency is the cost of the levels over the time of all cores until the last shard has a result; overhead are starts and levels of other shards, slow is what stragglers took longer, lost are attempts that died or came second. What is left is idle, or belongs to a machine that is down.',
  ],
});
