import { exponential } from '../../elementary.ts';
import { Z_90 } from '../../robustness/index.ts';

/** One player's attempts: the player's skill in standard deviations above the median factor, and which attempts succeeded. */
export interface SkilledPlayer {
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
export function predictRates(players: readonly SkilledPlayer[], attempts: number): (readonly [low: number, high: number])[] {
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
