import { compile, type Scene } from '../engine/index.ts';
import type { Hold } from '../schema/index.ts';
import { certify, createSolver, type Goal, measureRobustness, type Solver, successProbability } from '../solver/index.ts';
import { accuracy, askedLevels, atLeast, atMost, define, LEVELS, mean, number, processorClock, words } from './harness/index.ts';
import { plainRestarts } from './plain-restarts.ts';

const ANY: Goal = { minerals: 'any' };
const SIGMA = 40;

// executions that neither contestant has seen
const SAMPLES = 4000;
const SEED = 20_261_121;

// ticks between two readings of the clock
const SLICE = 50_000;

/** Executions by which gq solve measures `robustness.p40`. */
const REPORTED = 1000;

/** Combinations tried for a certificate: 5^7, that is seven presses or releases by up to two ticks. */
const CERTIFY_RUNS = 80_000;

const probability = (scene: Scene, holds: readonly Hold[] | null): number =>
  holds === null ? 0 : successProbability(scene, holds, ANY, SIGMA, { samples: SAMPLES, seed: SEED }).p;

/** The largest number of certified ticks among the runs found. */
function certificate(scene: Scene, { solutions }: Solver): number {
  const options = { limit: 4, maxRuns: CERTIFY_RUNS };
  return solutions.reduce((most, { holds }) => (most >= 2 ? most : Math.max(most, certify(scene, holds, ANY, options).ticks)), 0);
}

/** Success of the best of plain restarts after so many ms of processor time. */
function contested(scene: Scene, budget: number): number {
  const restarts = plainRestarts(scene);
  const spent = processorClock();
  while (restarts.p < 1 && spent() < budget) restarts.step();
  return probability(scene, restarts.holds);
}

export const bench = define({
  what: 'success of the best run under timing noise, against plain restarts (10 s per level and contestant)',
  options: {
    ...LEVELS,
    only: words('levels whose names contain one of these'),
    accuracy: accuracy('arcade'),
    ticks: number(null, 'ticks that the solver gets instead of time, without restarts'),
    seconds: number(10, 'processor time for each level and contestant'),
    seed: number(0, 'the seed'),
  },
  claims: {
    mean: atLeast(0.93, 'mean success'),
    least: atLeast(0.3, 'least success of a level'),
    flattery: atMost(0.005, 'mean of robustness.p40 minus fresh success'),
    // 3.3 standard deviations at p = 0.5, so that one level in a thousand is off by chance
    difference: atMost(0.06, 'largest difference of a level'),
    restarts: atMost(0.8, 'failures beside those of plain restarts, the same budget'),
    unsolved: atMost(0, 'levels without a run found'),
  },
  run({ only, accuracy: name, ticks, seconds, seed, ...asked }) {
    const budget = 1000 * seconds;
    const entries = askedLevels(asked).filter((entry) => only === null || only.some((part) => entry.name.includes(part)));
    const results = entries.map((entry) => {
      const scene = compile(entry.level, name);
      const solver = createSolver(scene, { seed, count: 3 });
      const spent = processorClock();
      const goesOn = () => (ticks === null ? spent() < budget : solver.effort.ticks < ticks);
      while (!solver.finished && goesOn()) solver.advance(SLICE);
      const took = spent() / 1000;
      const { best } = solver;
      const p = probability(scene, best?.holds ?? null);
      const claimed =
        best === null ? null : measureRobustness(scene, best.holds, ANY, { samples: REPORTED, seed, maxRuns: 1 }).p40.p;
      const plain = ticks === null ? contested(scene, budget) : null;
      if (process.stderr.isTTY) process.stderr.write(`${entry.name}: ${p} ${claimed} ${plain}\n`);
      const certified = certificate(scene, solver);
      return { name: entry.name, p, claimed, plain, seconds: took, ticks: solver.effort.ticks, best, certified };
    });
    const ours = mean(results.map(({ p }) => p));
    const theirs = ticks === null ? mean(results.map(({ plain }) => plain ?? 0)) : null;
    const flattery = results.flatMap(({ p, claimed }) => (claimed === null ? [] : [claimed - p]));
    return {
      title: `Success under ${SIGMA} ms of timing noise, accuracy ${name}, ${ticks === null ? `${seconds} s of processor time` : `${ticks / 1e6} million ticks`} a level`,
      columns: [
        ...['level', 'P(40 ms)', 'robustness.p40', 'plain restarts', 'certified ticks', 'presses', 'length s', 'seconds'],
        'million ticks',
      ],
      rows: [
        ...results.map((row) => [
          row.name,
          row.p,
          row.claimed,
          row.plain,
          row.certified,
          row.best?.holds.length ?? null,
          row.best?.time ?? null,
          row.seconds,
          row.ticks / 1e6,
        ]),
        ['mean', ours, ours + mean(flattery), theirs, null, null, null, mean(results.map((row) => row.seconds)), null],
      ],
      measured: {
        mean: ours,
        least: Math.min(...results.map(({ p }) => p)),
        flattery: mean(flattery),
        difference: Math.max(...flattery.map(Math.abs)),
        restarts: theirs === null ? null : (1 - ours) / Math.max(1 - theirs, 1e-3),
        unsolved: results.filter(({ best }) => best === null).length,
      },
      notes: [
        `P: ${SAMPLES} executions with noise that neither contestant has seen. robustness.p40: ${REPORTED} executions, as gq solve measures it.`,
        "Certified: ALL shifts of every edge by so many ticks succeed, for one of up to three runs found; 0 also where 80,000 runs don't suffice to tell.",
      ],
    };
  },
});
