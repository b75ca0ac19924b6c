import type { Scene } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import type { Goal } from '../goal.ts';
import { type Success, successProbability } from '../robustness/index.ts';

/** The timing noise at which every second attempt succeeds. */
export interface SigmaAtHalf {
  /** ms */
  readonly ms: number;
  /** 95 % interval, ms: where Wilson's interval for P leaves 0.5 on either side */
  readonly low: number;
  readonly high: number;
  /** True when P is still at least 0.5 at {@link SIGMA_CAP}, which then is given as `ms`. */
  readonly capped: boolean;
}

/** No more noise than this is tried, ms: half a second off is not playing any more. */
export const SIGMA_CAP = 500;

/** Between two noises so near each other success runs straight, ms: a tick is 16.7, and a thousand executions leave doubt of ten. */
const STRAIGHT = 4;
const ASIDE = 0.45 * STRAIGHT;

/** Where nothing is known, this noise is tried first, ms, and then twice as much. */
const FIRST = 60;

/**
 * Looks for the noise at which P = 0.5. All noises are laid with the same seed, so P changes with sigma and not by chance.
 * Where P crosses 0.5 more than once, one of the crossings is found.
 * @param options `known`: successes measured before, with the same samples and seed
 */
export function findSigmaAtHalf(
  scene: Scene,
  holds: readonly Hold[],
  goal: Goal,
  options: { readonly samples: number; readonly seed: number; readonly known?: readonly Success[] },
): SigmaAtHalf {
  const { samples, seed, known = [] } = options;
  const curve = new Curve(known, (sigma) => successProbability(scene, holds, goal, sigma, { samples, seed }));
  const ms = curve.crossing(({ p }) => p);
  return {
    ms,
    low: curve.crossing(({ low }) => low),
    high: curve.crossing(({ high }) => high),
    capped: ms === SIGMA_CAP,
  };
}

/** Success over noise, as far as it is known: what one question has measured serves the next. */
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
   * The sigma at which a figure falls below 0.5; the cap where it is above to the end. It is looked for where a straight line
   * through the ends of where it is known to be has it, a little aside, so that both ends close in; every third time in the middle.
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
