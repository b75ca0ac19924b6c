import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
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
import { atMost, define, mean, nearestRank, number, PROJECT, sum } from './harness/index.ts';

/** Fleets that do each set. */
const FLEETS = 10;
const SHARDS = [10, 30, 100, 300, 1000, 3000, 10_000];
/** Those of the table. */
const SHOWN = [10, 100, 1000, 10_000];
const HOUR = 3600;

const ASSUMED: Omit<Assumptions, 'measured'> = {
  levels: 10_000_000,
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
const { levels, fleet, patience } = ASSUMED;
const SLOTS = fleet.machines * fleet.cores;
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

function slowestOverMean({ useful, overhead }: ShardCosts): number {
  const all = useful.map((cost, shard) => cost + overhead[shard]);
  return all.reduce((a, b) => Math.max(a, b)) / (sum(all) / all.length);
}

/** Simulates every plan: each set is drawn once, split into each number of shards, and done by each fleet. */
function simulateAll(sets: number, measured: Assumptions['measured']): Cell[] {
  const cells: Cell[] = PLANS.flatMap((plan) =>
    SHARDS.flatMap((shards) => plan.cases.map((one): Cell => ({ plan, shards, case: one, outcomes: [], slowest: [] }))),
  );
  for (let seed = 0; seed < sets; seed++) {
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
  return cells;
}

const hoursOf = ({ outcomes }: Cell): number => mean(outcomes.map(({ makespan }) => makespan)) / HOUR;
const p95Of = ({ outcomes }: Cell): number =>
  nearestRank(
    outcomes.map(({ makespan }) => makespan),
    0.95,
  ) / HOUR;
/** A part of the time of all slots, %. */
const shareOf = ({ outcomes }: Cell, of: 'useful' | 'overhead' | 'slow' | 'lost'): number =>
  100 * mean(outcomes.map((outcome) => outcome[of] / (SLOTS * outcome.makespan)));

const percentOver = (value: number, base: number): number => 100 * (value / base - 1);

/** How far equal shards without failures are from ceil(shards / SLOTS) times the cost of one, as a share. */
function errorOfEqualShards(): number {
  const cost = 37.5;
  const equal = (shards: number): ShardCosts => ({
    useful: new Float64Array(shards).fill(cost),
    overhead: new Float64Array(shards),
  });
  return Math.max(
    ...SHARDS.map((shards) => {
      const { makespan } = simulateFleet(equal(shards), NO_FAILURES, AT_ONCE, seeded(0));
      return Math.abs(makespan / (Math.ceil(shards / SLOTS) * cost) - 1);
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

export const bench = define({
  what: 'a simulated fleet of machines that fail: hours and losses with 10 to 10,000 shards; draws docs/fleet-model.svg; 2 minutes',
  options: { sets: number(10, 'sets that are drawn') },
  claims: {
    equal: atMost(1e-9, 'equal shards without failures against ceil(shards / cores) x cost, relative error'),
    restarts: atMost(4, 'a shard that dies against (e^(rate T) - 1) / rate, standard errors'),
    twice: atMost(0, 'simulations in which a shard was counted twice or never'),
    failures: atMost(50, '1,000 shards of searches with failures and copies, over the same without, %'),
    ideal: atMost(75, 'the same over the ideal, %'),
    p95: atMost(95, 'the same, p95 over the ideal, %'),
    copies: atMost(0.95, 'the same with copies against without, time'),
  },
  async run({ sets }) {
    const measured = await measureCosts();
    const cells = simulateAll(sets, measured);
    const cellOf = (job: Plan['job'], split: Split, shards: number, one: Case): Cell =>
      cells.find((cell) => cell.plan.job === job && cell.plan.split === split && cell.shards === shards && cell.case === one)!;
    const idealOf = (costs: LevelCosts): number => (levels * mean(costs)) / SLOTS / HOUR;
    /** All work over all slots, h. */
    const ideal = { search: idealOf(measured.search), replay: idealOf(measured.replay) };
    const lineOf = (job: Plan['job'], one: Case): Line => ({
      name: one.name,
      dashes: one.dashes,
      points: SHARDS.map((shards) => ({ shards, hours: hoursOf(cellOf(job, 'rule', shards, one)) })),
    });

    const millions = `${levels / 1e6} million`;
    const panels = (['search', 'replay'] as const).map((job) => ({
      title: `${millions} ${job === 'search' ? 'searches' : 'replays'}`,
      lines: [NONE, RERUN, COPIES].map((one) => lineOf(job, one)),
      ideal: ideal[job],
    }));
    writeFileSync(
      join(PROJECT, 'docs/fleet-model.svg'),
      drawFleet(panels, `${fleet.machines} machines with ${fleet.cores} cores`),
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

    return {
      title: `${millions} levels on ${SLOTS} cores, simulated: ${sets} sets, ${FLEETS} fleets for each`,
      columns: [
        ...['job', 'shards', 'split', 'failures', 'h, mean', 'h, p95', 'efficiency %', 'overhead %', 'slow %', 'lost %'],
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
      measured: {
        equal: errorOfEqualShards(),
        restarts: errorOfRestarts(),
        twice,
        failures: percentOver(hoursOf(thousand.copies), hoursOf(thousand.none)),
        ideal: percentOver(hoursOf(thousand.copies), ideal.search),
        p95: percentOver(p95Of(thousand.copies), ideal.search),
        copies: hoursOf(thousand.copies) / hoursOf(thousand.rerun),
      },
      notes: [
        ...inWords({ ...ASSUMED, measured }),
        `Ideal, all levels over all cores: ${ideal.search.toFixed(2)} h of searches, ${ideal.replay.toFixed(4)} h of replays. Besides, on one core: gq plan ${((levels * measured.plan) / HOUR).toFixed(2)} h, gq merge ${((levels * measured.merge) / HOUR).toFixed(2)} h.`,
        `Every shard reads the whole set. With 1,000 shards this costs ${scanOver('replay').toFixed(1)} times as much as all replays, and ${(100 * scanOver('search')).toFixed(0)} % of all searches. Of the numbers tried, ${best('search', COPIES)} shards are fastest for searches with failures and copies, ${best('replay', COPIES)} for replays.`,
        'Efficiency is the cost of the levels over the time of all cores until the last shard has a result; overhead are starts and levels of other shards, slow is what stragglers took longer, lost are attempts that died or came second. What is left is idle, or belongs to a machine that is down.',
      ],
    };
  },
});
