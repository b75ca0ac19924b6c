import { joinHolds, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import { type Goal, verifyRun } from '../../verified-run.ts';
import { createTrials, type Trials, uniformOf, wilsonInterval, Z_90 } from '../robustness/index.ts';
import { exponential, normalQuantile } from './elementary.ts';
import { type PlayerParameters, UNCALIBRATED } from './parameters.ts';
import { type PlayedAttempt, Player, practiceTable, type TimedRun, timeRun, typicalError, uniformIn01 } from './player.ts';

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
  /** The rates between which a player's own pass rate at this attempt is with 90 % probability, by a regression on skill. */
  readonly range: readonly [low: number, high: number];
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
  /** How many players were simulated. */
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
  /** An attempt fails when it lasts longer than this, ticks; that of the scene by default. */
  readonly maxTicks?: number;
}

/** Index of the draw of a player's skill, apart from those of the edges. */
const SKILL = 1_000_000;

/** How often an edge is practised at most before practice no longer counts. */
const MOST_PRACTICE = 100;

/** What is needed to let players play. */
interface Stand {
  readonly trials: Trials;
  readonly parameters: PlayerParameters;
  readonly run: TimedRun;
  readonly left: Float64Array;
  /** The n-th player, and the player's skill in standard deviations. */
  draw(n: number): { readonly player: Player; readonly skill: number };
}

/** @throws {Error} if the run misses the goal */
function standFor(scene: Scene, holds: readonly Hold[], goal: Goal, options: PlayerOptions): Stand {
  const { parameters = UNCALIBRATED, seed = 0, maxTicks } = options;
  const aim = verifyRun(scene, holds, goal, maxTicks);
  if (aim === null) throw new Error('the run that players aim at misses the goal');
  const joined = joinHolds(holds);
  const run = timeRun(joined.flat(), aim.tick, parameters);
  const left = practiceTable(parameters.learning, MOST_PRACTICE);
  const trials = createTrials(scene, goal, maxTicks);
  const start = trials.simulation.snapshot();
  return {
    ...{ trials, parameters, run, left },
    draw(n) {
      const own = uniformOf(seed, n, 0);
      const skill = normalQuantile(uniformIn01(own, 0, SKILL));
      const factor = parameters.scale * exponential(parameters.spread * skill);
      return { player: new Player(trials, start, joined, run, left, factor, own), skill };
    },
  };
}

/**
 * Lets synthetic players of mixed skill play, and returns what they did: plays whose parameters are known, to test what is inferred
 * from plays.
 * @param scene the compiled level
 * @param holds the run to aim at, [press, release) in ticks; it must meet the goal
 * @param goal what an attempt has to achieve
 * @param players how many players
 * @param options the parameters, the number of attempts, the seed and the limit of an attempt
 * @returns the attempts of each player, in order
 * @throws {Error} if the run misses the goal
 */
export function playAsPlayers(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  players: number,
  options: PlayerOptions = {},
): PlayedAttempt[][] {
  const { attempts = 10 } = options;
  const stand = standFor(scene, holds, goal, options);
  return Array.from({ length: players }, (_, n) => {
    const { player } = stand.draw(n);
    return Array.from({ length: attempts }, () => player.attempt());
  });
}

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
  const { attempts = 10 } = options;
  const stand = standFor(scene, holds, goal, options);
  const { trials, parameters, run, left } = stand;
  const finished: SkilledPlayer[] = [];

  function* play(): Generator<void, never> {
    for (;;) {
      const { player, skill } = stand.draw(finished.length);
      const passes: boolean[] = [];
      for (let i = 0; i < attempts; i++) {
        passes.push(player.attempt().succeeds);
        yield;
      }
      // only whole players count, so that no attempt number is over-represented
      finished.push({ skill, passes });
    }
  }
  const work = play();
  let asked = 0;
  const share = (holds: (player: SkilledPlayer) => boolean): PlayerShare => {
    const count = finished.filter(holds).length;
    return { p: finished.length === 0 ? 0 : count / finished.length, ...wilsonInterval(count, finished.length, Z_90) };
  };
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
      const ranges = predictRates(finished, attempts);
      const all = Array.from({ length: attempts }, (_, i) => ({
        number: i + 1,
        pass: share(({ passes }) => passes[i]),
        range: ranges[i],
        solved: share(({ passes }) => passes.lastIndexOf(true, i) >= 0),
      }));
      const after = (least: number) => all.find((row) => row.solved.p >= least)?.number ?? null;
      return {
        parameters,
        firstErrorMs: typicalError(run, left[0], parameters.scale),
        lastErrorMs: typicalError(run, left[Math.min(attempts - 1, MOST_PRACTICE)], parameters.scale),
        players: finished.length,
        attempts: all,
        half: after(0.5),
        most: after(0.9),
      };
    },
  };
}

/** One player's attempts: the player's skill in standard deviations above the median factor, and which attempts succeeded. */
interface SkilledPlayer {
  readonly skill: number;
  readonly passes: readonly boolean[];
}

/** Newton's method takes fewer steps than this. */
const STEPS = 50;

/** Weight of a success and of a failure at either side, which keep the curve finite where all attempts succeed, or all fail. */
const PRIOR = 0.25;
const PRIOR_SKILLS = [-1, 1] as const;

/**
 * Predicts between which pass rates a player's own is with 90 % probability, at each attempt. The rate falls with the noise of a
 * player: a logistic regression on skill (D. R. Cox, The regression analysis of binary
 * sequences, 1958), by Newton's method. Every attempt number has a level of its own; the slope is the same for all, since the attempts
 * of one number alone tell it too badly. Skills are normally distributed, and so are the logits of the rates; the error of the level
 * widens their distribution.
 * @param attempts how many attempts each player has
 */
function predictRates(players: readonly SkilledPlayer[], attempts: number): (readonly [low: number, high: number])[] {
  const levels = new Float64Array(attempts);
  let slope = 0;
  const gradient = new Float64Array(attempts);
  const bend = new Float64Array(attempts);
  const mixed = new Float64Array(attempts);
  for (let step = 0; step < STEPS; step++) {
    gradient.fill(0);
    bend.fill(0);
    mixed.fill(0);
    let [slopeGradient, slopeBend] = [0, 0];
    const add = (attempt: number, skill: number, passed: number, weight: number): void => {
      const p = logistic(levels[attempt] + slope * skill);
      const miss = passed - weight * p;
      const curvature = weight * p * (1 - p);
      gradient[attempt] += miss;
      bend[attempt] += curvature;
      mixed[attempt] += curvature * skill;
      slopeGradient += miss * skill;
      slopeBend += curvature * skill * skill;
    };
    for (let attempt = 0; attempt < attempts; attempt++) {
      for (const { skill, passes } of players) add(attempt, skill, passes[attempt] ? 1 : 0, 1);
      for (const skill of PRIOR_SKILLS) add(attempt, skill, PRIOR, 2 * PRIOR);
    }
    // the matrix is an arrow: eliminate the levels, then the slope is left
    for (let i = 0; i < attempts; i++) {
      slopeGradient -= (mixed[i] * gradient[i]) / bend[i];
      slopeBend -= (mixed[i] * mixed[i]) / bend[i];
    }
    const by = limited(slopeGradient / slopeBend);
    let moved = Math.abs(by);
    for (let i = 0; i < attempts; i++) {
      const own = limited((gradient[i] - mixed[i] * by) / bend[i]);
      levels[i] += own;
      moved = Math.max(moved, Math.abs(own));
    }
    slope += by;
    if (moved < 1e-9) break;
  }
  return Array.from(levels, (level, i) => {
    const reach = Z_90 * Math.sqrt(slope * slope + 1 / bend[i]);
    return [logistic(level - reach), logistic(level + reach)];
  });
}

/** A step that does not overshoot from a flat start. */
const limited = (step: number): number => Math.min(2, Math.max(-2, step));

const logistic = (x: number): number => 1 / (1 + exponential(Math.min(30, Math.max(-30, -x))));
