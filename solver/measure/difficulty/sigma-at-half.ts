import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { Goal } from '../../verified-run.ts';
import { type Success, successProbability } from '../robustness/index.ts';

/** The timing noise at which half of all attempts succeed. */
export interface SigmaAtHalf {
  /** Standard deviation of the noise, ms. */
  readonly ms: number;
  /** Lower end of the 95 % confidence interval, ms: where the lower end of Wilson's interval of the success falls below 0.5. */
  readonly low: number;
  /** Upper end of the 95 % confidence interval, ms: where the upper end of Wilson's interval falls below 0.5. */
  readonly high: number;
  /** True when success is still at least 0.5 at 500 ms, the most noise that is tried; `ms` is then 500. */
  readonly capped: boolean;
}

/** The most noise that is tried, ms: nobody who is half a second off is still playing. */
export const SIGMA_CAP = 500;

/**
 * Success is taken as linear between two noises as close as this, ms. A tick is 16.7 ms, and the error of a thousand attempts
 * is about 10 ms.
 */
const STRAIGHT = 4;
const ASIDE = 0.45 * STRAIGHT;

/** The first noise to try when nothing is known, ms. It is doubled until success falls below 0.5. */
const FIRST = 60;

/**
 * Finds the noise at which success is 0.5. All noises use the same seed, so that success changes with the noise and not by
 * chance. If success crosses 0.5 more than once, one of the crossings is found.
 * @param options how attempts are sampled; `known` holds successes measured before with the same samples and seed
 */
export function findSigmaAtHalf(scene: Scene, holds: readonly Hold[], goal: Goal, options: CurveOptions): SigmaAtHalf {
  const curve = curveOf(scene, holds, goal, options);
  const ms = curve.crossing(({ p }) => p);
  return {
    ms,
    low: curve.crossing(({ low }) => low),
    high: curve.crossing(({ high }) => high),
    capped: ms === SIGMA_CAP,
  };
}

/** {@link findSigmaAtHalf} without the confidence interval, at less than half of its cost. */
export const sigmaAtHalfOf = (scene: Scene, holds: readonly Hold[], goal: Goal, options: CurveOptions): number =>
  curveOf(scene, holds, goal, options).crossing(({ p }) => p);

interface CurveOptions {
  readonly samples: number;
  readonly seed: number;
  readonly known?: readonly Success[];
}

function curveOf(scene: Scene, holds: readonly Hold[], goal: Goal, { samples, seed, known = [] }: CurveOptions): Curve {
  return new Curve(known, (sigma) => successProbability(scene, holds, goal, sigma, { samples, seed }));
}

/** Success as a function of noise, measured where it is needed and remembered. */
class Curve {
  private readonly points: Success[];

  constructor(
    known: readonly Success[],
    private readonly measure: (sigma: number) => Success,
  ) {
    const certain: Success = { sigma: 0, p: 1, low: 1, high: 1, samples: 1 };
    this.points = [certain, ...known].sort((a, b) => a.sigma - b.sigma);
  }

  private at(sigma: number): Success {
    const { points } = this;
    let place = points.length;
    while (points[place - 1].sigma > sigma) place--;
    if (points[place - 1].sigma === sigma) return points[place - 1];
    const success = this.measure(sigma);
    points.splice(place, 0, success);
    return success;
  }

  /**
   * The noise at which a figure falls below 0.5, or the cap if it never does. The crossing is bracketed, and the next
   * measurement lies a little beside where a straight line between both ends crosses 0.5 (regula falsi), so that both ends
   * close in; every third one bisects.
   */
  crossing(figure: (success: Success) => number): number {
    const { points } = this;
    while (points.every((success) => figure(success) >= 0.5)) {
      const { sigma } = points[points.length - 1];
      if (sigma >= SIGMA_CAP) return SIGMA_CAP;
      this.at(Math.min(SIGMA_CAP, Math.max(2 * sigma, FIRST)));
    }
    const end = points.findIndex((success) => figure(success) < 0.5);
    let below = points[end];
    let above = points[end - 1];
    const straight = () => (figure(above) - 0.5) / (figure(above) - figure(below));
    for (let n = 1; below.sigma - above.sigma > STRAIGHT; n++) {
      const width = below.sigma - above.sigma;
      const part = n % 3 === 0 ? 0.5 : straight();
      const aside = Math.min(ASIDE, width / 4);
      const next = this.at(above.sigma + part * width + (part < 0.5 ? aside : -aside));
      if (figure(next) >= 0.5) above = next;
      else below = next;
    }
    return above.sigma + straight() * (below.sigma - above.sigma);
  }
}
