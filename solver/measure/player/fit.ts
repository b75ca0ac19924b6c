import { normalBeyondHalf, Z_90 } from '../robustness/index.ts';
import { exponential, logarithm } from './elementary.ts';
import { Evidence, type ObservedAttempt } from './evidence.ts';
import { type PlayerParameters, UNCALIBRATED } from './parameters.ts';
import { practiceTable, timeRun } from './player.ts';

export type { ObservedAttempt } from './evidence.ts';

/** A fitted parameter. */
export interface FitInterval {
  /** The most likely value. */
  readonly value: number;
  /** Lower end of the 90 % confidence interval (profile likelihood). */
  readonly low: number;
  /** Upper end of the 90 % confidence interval. */
  readonly high: number;
}

/** The player model, fitted to plays. */
export interface PlayerFit {
  /** How many players the plays are of. */
  readonly players: number;
  /** How many attempts they made. */
  readonly attempts: number;
  /** How many presses and releases were compared with the run. */
  readonly edges: number;
  /** The noise of the median player, as a multiple of the uncalibrated model's. */
  readonly scale: FitInterval;
  /** The exponent of the power law of practice. */
  readonly learning: FitInterval;
  /** How much players differ: the standard deviation of the logarithm of their factors. null with a single player. */
  readonly spread: FitInterval | null;
  /** The model with these values. */
  readonly parameters: PlayerParameters;
}

/** Steps of the grid on which the likelihood is computed. */
const SCALE_STEP = 0.05;
const LEARNING_STEP = 0.1;
const SPREAD_STEP = 0.05;

/** The grid: factors from 1/12 to 12, exponents from 0 to 1.5, spreads from 0 to 1.5. */
const HALF_SCALES = 50;
const SCALES = 2 * HALF_SCALES + 1;
const LEARNINGS = 16;
const SPREADS = 31;

const MOST_PRACTICE = 1000;

const FACTORS = Float64Array.from({ length: SCALES }, (_, i) => exponential((i - HALF_SCALES) * SCALE_STEP));

/** Indices of scale, learning and spread on the grid. */
type GridPoint = readonly [scale: number, learning: number, spread: number];

const SIZES = [SCALES, LEARNINGS, SPREADS] as const;

/** Where the climb begins: at the uncalibrated model, so that what the plays don't tell stays as it is. */
const BEGIN: GridPoint = [
  HALF_SCALES,
  Math.round(UNCALIBRATED.learning / LEARNING_STEP),
  Math.round(UNCALIBRATED.spread / SPREAD_STEP),
];

/**
 * Fits the player model to plays by maximum likelihood. Every press and release is an error with a known distribution: its variance
 * depends on the interval before it, on what follows, on how often the player has practised it, and on the player's factor, which is
 * integrated over the log-normal distribution of factors. A press or release that had not come when the attempt ended counts as
 * later than that (right-censored). Intervals are those of the profile likelihood; those of scale
 * and learning use Student's instead of the normal distribution, since a few players are a small sample.
 *
 * @param edges when the run that players aim at changes the button, ticks
 * @param end when that run ends, ticks
 * @param players the attempts of each player, in order
 * @param base the model whose scale, learning and spread are fitted
 * @returns null where no press or release can be compared with the run
 */
export function fitPlayers(
  edges: readonly number[],
  end: number,
  players: readonly (readonly ObservedAttempt[])[],
  base: PlayerParameters = UNCALIBRATED,
): PlayerFit | null {
  const run = timeRun(edges, end, base);
  const all = players.map((attempts) => ({ evidence: new Evidence(run, attempts), attempts: attempts.length }));
  const evidence = all.filter(({ evidence: { seen } }) => seen > 0);
  if (evidence.length === 0) return null;
  const surface = new Surface(evidence.map((own) => own.evidence));
  const isAlone = evidence.length === 1;
  const best = surface.climb(isAlone ? [BEGIN[0], BEGIN[1], 0] : BEGIN, isAlone ? [0, 1] : [0, 1, 2]);
  const z = isAlone ? Z_90 : studentQuantile(evidence.length - 1);
  const scale = surface.interval(best, 0, isAlone, z);
  const learning = surface.interval(best, 1, isAlone, z);
  const spread = isAlone ? null : surface.interval(best, 2, isAlone, Z_90);
  const toFactor = (at: number): number => exponential((at - HALF_SCALES) * SCALE_STEP);
  const fitted = {
    scale: mapped(scale, toFactor),
    learning: mapped(learning, (at) => at * LEARNING_STEP),
    spread: spread === null ? null : mapped(spread, (at) => at * SPREAD_STEP),
  };
  return {
    players: evidence.length,
    attempts: evidence.reduce((sum, { attempts }) => sum + attempts, 0),
    edges: evidence.reduce((sum, { evidence: { seen } }) => sum + seen, 0),
    ...fitted,
    parameters: {
      ...base,
      scale: base.scale * fitted.scale.value,
      learning: fitted.learning.value,
      spread: fitted.spread?.value ?? 0,
    },
  };
}

const mapped = ({ value, low, high }: FitInterval, map: (at: number) => number): FitInterval => ({
  value: map(value),
  low: map(low),
  high: map(high),
});

/** The 95 % quantile of Student's distribution, by the first terms of its Cornish-Fisher expansion; within 2 % from 3 degrees on. */
function studentQuantile(degrees: number): number {
  const z = Z_90;
  const z3 = z * z * z;
  const z5 = z3 * z * z;
  return z + (z3 + z) / (4 * degrees) + (5 * z5 + 16 * z3 + 3 * z) / (96 * degrees * degrees);
}

/** The log-likelihood on the grid, computed where it is asked for. */
class Surface {
  private readonly curves = new Map<number, Float64Array[]>();
  private readonly known = new Map<number, number>();
  private readonly masses = new Map<number, Float64Array>();

  constructor(private readonly evidence: readonly Evidence[]) {}

  at([scale, learning, spread]: GridPoint): number {
    const key = (scale * LEARNINGS + learning) * SPREADS + spread;
    const known = this.known.get(key);
    if (known !== undefined) return known;
    const mass = this.massOf(spread);
    const reach = (mass.length - 1) / 2;
    let sum = 0;
    for (const curve of this.curvesOf(learning)) {
      const from = Math.max(0, scale - reach);
      const to = Math.min(SCALES - 1, scale + reach);
      let most = Number.NEGATIVE_INFINITY;
      for (let i = from; i <= to; i++) most = Math.max(most, curve[i]);
      let mean = 0;
      for (let i = from; i <= to; i++) mean += mass[i - scale + reach] * exponential(Math.max(-600, curve[i] - most));
      sum += most + logarithm(Math.max(mean, 1e-300));
    }
    this.known.set(key, sum);
    return sum;
  }

  /** Climbs to the highest point, along the given axes. */
  climb(from: GridPoint, axes: readonly number[]): GridPoint {
    let here = from;
    for (;;) {
      let best = here;
      for (const next of neighbours(here, axes)) if (this.at(next) > this.at(best)) best = next;
      if (best === here) return here;
      here = best;
    }
  }

  /**
   * The most likely value of one axis and where the profile likelihood falls by z^2 / 2, in steps of the grid. The root of twice the
   * fall is nearly a straight line, so it is interpolated linearly.
   */
  interval(best: GridPoint, axis: number, isAlone: boolean, z: number): FitInterval {
    const others = [0, 1, 2].filter((other) => other !== axis && !(isAlone && other === 2));
    const values = new Map<number, number>([[best[axis], this.at(best)]]);
    const walk = (direction: 1 | -1, enough: (value: number) => boolean): void => {
      let here = best;
      for (;;) {
        const at = here[axis] + direction;
        if (at < 0 || at >= SIZES[axis]) return;
        here = this.climb(here.map((value, i) => (i === axis ? at : value)) as unknown as GridPoint, others);
        values.set(at, this.at(here));
        if (enough(this.at(here))) return;
      }
    };
    const top = this.at(best);
    // a little further than needed: the peak lies between the points of the grid
    const isBelow = (value: number) => 2 * (top - value) > (z + 1) * (z + 1);
    walk(1, isBelow);
    walk(-1, isBelow);
    const peak = vertex(best[axis], values);
    const end = (direction: 1 | -1): number => {
      let inside = { at: peak.at, root: 0 };
      const first = direction === 1 ? Math.floor(peak.at) + 1 : Math.ceil(peak.at) - 1;
      for (let at = first; ; at += direction) {
        const value = values.get(at);
        if (value === undefined) return inside.at;
        const root = Math.sqrt(Math.max(0, 2 * (peak.value - value)));
        if (root >= z) return inside.at + ((z - inside.root) / (root - inside.root)) * (at - inside.at);
        inside = { at, root };
      }
    };
    return { value: peak.at, low: end(-1), high: end(1) };
  }

  private curvesOf(learning: number): Float64Array[] {
    const known = this.curves.get(learning);
    if (known !== undefined) return known;
    const left = practiceTable(learning * LEARNING_STEP, MOST_PRACTICE);
    const curves = this.evidence.map((own) => own.curve(FACTORS, left));
    this.curves.set(learning, curves);
    return curves;
  }

  /** The log-normal distribution of factors as masses of the grid's points around its median. */
  private massOf(spread: number): Float64Array {
    const known = this.masses.get(spread);
    if (known !== undefined) return known;
    const deviation = (spread * SPREAD_STEP) / SCALE_STEP;
    const reach = Math.min(SCALES, Math.ceil(4 * deviation));
    const below = (steps: number) => normalBeyondHalf(Math.min(6, Math.max(-6, steps / deviation)));
    const mass = Float64Array.from({ length: 2 * reach + 1 }, (_, i) =>
      deviation === 0 ? 1 : below(i - reach + 0.5) - below(i - reach - 0.5),
    );
    this.masses.set(spread, mass);
    return mass;
  }
}

/** The points around a point, along the given axes, corners included. */
function neighbours(point: GridPoint, axes: readonly number[]): GridPoint[] {
  let points: number[][] = [[...point]];
  for (const axis of axes) {
    points = points.flatMap((own) =>
      [-1, 0, 1].flatMap((step) => {
        const at = own[axis] + step;
        return at < 0 || at >= SIZES[axis] ? [] : [own.map((value, i) => (i === axis ? at : value))];
      }),
    );
  }
  return points as unknown as GridPoint[];
}

/** The top of the parabola through the highest point and its two neighbours. */
function vertex(at: number, values: ReadonlyMap<number, number>): { at: number; value: number } {
  const [before, here, after] = [values.get(at - 1), values.get(at) as number, values.get(at + 1)];
  if (before === undefined || after === undefined) return { at, value: here };
  const bend = before - 2 * here + after;
  if (bend >= 0) return { at, value: here };
  const shift = Math.min(0.5, Math.max(-0.5, (before - after) / (2 * bend)));
  return { at: at + shift, value: here - ((before - after) * (before - after)) / (8 * bend) };
}
