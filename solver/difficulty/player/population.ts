import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { exponential } from '../../elementary.ts';
import type { Goal } from '../../goal.ts';
import { createTrials, uniformOf, wilsonInterval, Z_90 } from '../../robustness/index.ts';
import { verifyRun } from '../../verified-run.ts';
import { normalQuantile } from './normal-quantile.ts';
import { type PlayerParameters, UNCALIBRATED } from './parameters.ts';
import { edgesOf, Player, uniformIn01 } from './player.ts';
import { practiceTable, timeRun, typicalError } from './timing.ts';

/** A share of synthetic players. */
export interface PlayerShare {
  /** The share, 0 to 1. */
  readonly p: number;
  /** Lower end of its 90 % confidence interval (Wilson's score interval), 0 to 1. */
  readonly low: number;
  /** Upper end of its 90 % confidence interval, 0 to 1. */
  readonly high: number;
}

/** How synthetic players fare at their first, second, ... attempt. */
export interface ForecastAttempt {
  /** Which attempt, from 1. */
  readonly number: number;
  /** The share that succeeds at this attempt, if all of them still play. */
  readonly pass: PlayerShare;
  /** The pass rate of a player who is better than 95 of 100. */
  readonly skilled: number;
  /** The pass rate of a player who is better than 5 of 100: nine in ten players are between this and `skilled`. */
  readonly unskilled: number;
  /** The share that has succeeded by then. */
  readonly solved: PlayerShare;
}

/** What a model of players expects of a level. It says nothing about people unless its parameters were fitted to their plays. */
export interface PlayerForecast {
  /** The parameters that were used. */
  readonly parameters: PlayerParameters;
  /** How much the median player misses the presses and releases by at first: the root mean square, ms. */
  readonly firstErrorMs: number;
  /** The same at the last attempt, after as much practice. */
  readonly lastErrorMs: number;
  /** How many players of mixed skill were simulated; another half as many at either end of the range of skill. */
  readonly players: number;
  /** Their attempts, ascending. */
  readonly attempts: readonly ForecastAttempt[];
  /** After how many attempts half of the players have succeeded; null: not within those simulated. */
  readonly half: number | null;
  /** After how many attempts nine in ten have succeeded; null: not within those simulated. */
  readonly most: number | null;
}

/** Synthetic players who play one level. The simulation can be stopped at any time, and has a forecast so far. */
export interface PlayerPopulation {
  /** Ticks simulated so far, and one for each attempt. */
  readonly ticks: number;
  /**
   * Simulates more players. The same total gives the same result however it is split into calls.
   * @param ticks how many more ticks to simulate; the last attempt may overshoot
   */
  advance(ticks: number): void;
  /** What the players that are finished so far show. */
  forecast(): PlayerForecast;
}

/** What {@link createPlayers} simulates. */
export interface PlayerOptions {
  /** What a player can do; by default the uncalibrated model. */
  readonly parameters?: PlayerParameters;
  /** How many attempts each player has; 10 by default. */
  readonly attempts?: number;
  /** Seed of all random choices, a whole number; 0 by default. */
  readonly seed?: number;
  /** An attempt fails when it lasts longer than this, ticks; 3600 by default. */
  readonly maxTicks?: number;
}

/** The quantiles of skill between which nine in ten players are. */
const SKILLED = -Z_90;
const UNSKILLED = Z_90;

/** Of four players, two have a skill drawn from the population, one is skilled and one is not. */
const TURNS = ['mixed', 'skilled', 'mixed', 'unskilled'] as const;

type Group = (typeof TURNS)[number];

const SEED_OF_GROUP: Readonly<Record<Group, number>> = { mixed: 0, skilled: 1, unskilled: 2 };

/** Index of the draw of a player's skill, apart from those of the edges. */
const SKILL = 1_000_000;

/** How often an edge is practised at most before practice no longer counts. */
const MOST_PRACTICE = 100;

/**
 * Creates synthetic players who aim at a run. Each has a skill of its own, plays a number of attempts and learns from them; see
 * {@link PlayerParameters} for how.
 * @param scene the compiled level
 * @param holds the run to aim at, [press, release) in ticks; it must meet the goal
 * @param goal what an attempt has to achieve
 * @param options the parameters, the number of attempts, the seed and the limit of an attempt
 * @throws {Error} if the run misses the goal
 */
export function createPlayers(scene: Scene, holds: readonly Hold[], goal: Goal, options: PlayerOptions = {}): PlayerPopulation {
  const { parameters = UNCALIBRATED, attempts = 10, seed = 0, maxTicks } = options;
  const aim = verifyRun(scene, holds, goal, maxTicks);
  if (aim === null) throw new Error('the run that players aim at misses the goal');
  const { joined, edges } = edgesOf(holds);
  const run = timeRun(edges, aim.tick, parameters);
  const left = practiceTable(parameters.learning, MOST_PRACTICE);
  const trials = createTrials(scene, goal, maxTicks);
  const start = trials.simulation.snapshot();
  const passed: Record<Group, Int32Array> = {
    mixed: new Int32Array(attempts),
    skilled: new Int32Array(attempts),
    unskilled: new Int32Array(attempts),
  };
  const solved = new Int32Array(attempts);
  const players: Record<Group, number> = { mixed: 0, skilled: 0, unskilled: 0 };

  function* play(): Generator<void, never> {
    const passes = new Uint8Array(attempts);
    for (let turn = 0; ; turn++) {
      const group = TURNS[turn % TURNS.length];
      const own = uniformOf(seed, players[group], SEED_OF_GROUP[group]);
      const skill = group === 'mixed' ? normalQuantile(uniformIn01(own, 0, SKILL)) : group === 'skilled' ? SKILLED : UNSKILLED;
      const factor = parameters.scale * exponential(parameters.spread * skill);
      const player = new Player(trials, start, joined, run, left, factor, own);
      for (let i = 0; i < attempts; i++) {
        passes[i] = player.attempt().succeeds ? 1 : 0;
        yield;
      }
      // only whole players count, so that no attempt number is over-represented
      players[group]++;
      for (let i = 0; i < attempts; i++) passed[group][i] += passes[i];
      const first = passes.indexOf(1);
      if (group === 'mixed' && first >= 0) for (let i = first; i < attempts; i++) solved[i]++;
    }
  }
  const work = play();
  let asked = 0;
  const share = (count: number): PlayerShare => ({
    p: players.mixed === 0 ? 0 : count / players.mixed,
    ...wilsonInterval(count, players.mixed, Z_90),
  });
  const rate = (group: Group, i: number): number => (players[group] === 0 ? 0 : passed[group][i] / players[group]);
  return {
    get ticks() {
      return trials.ticks + trials.runs;
    },
    advance(ticks) {
      asked += ticks;
      // an attempt costs at least a tick, even where it is over at once
      while (trials.ticks + trials.runs < asked) work.next();
    },
    forecast() {
      const rows = Array.from({ length: attempts }, (_, i) => ({
        number: i + 1,
        pass: share(passed.mixed[i]),
        skilled: rate('skilled', i),
        unskilled: rate('unskilled', i),
        solved: share(solved[i]),
      }));
      const after = (least: number) => rows.find((row) => row.solved.p >= least)?.number ?? null;
      return {
        parameters,
        firstErrorMs: typicalError(run, left[0], parameters.scale),
        lastErrorMs: typicalError(run, left[Math.min(attempts - 1, MOST_PRACTICE)], parameters.scale),
        players: players.mixed,
        attempts: rows,
        half: after(0.5),
        most: after(0.9),
      };
    },
  };
}
