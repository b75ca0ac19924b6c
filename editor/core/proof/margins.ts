import { boxCircleGap, type Scene, STATE_SIZE } from '../../../engine/index.ts';
import type { Way } from './recorder.ts';

/** A moment at which she passes a hazard closely. */
export interface NearMiss extends Hazard {
  readonly tick: number;
  /** between her box and the hazard, px */
  readonly gap: number;
}

/** Along a trajectory, one entry per tick. */
export interface Margins {
  /** px between her box and the nearest hazard; infinite if the level has none */
  readonly gap: Float32Array;
  /** px/s */
  readonly speed: Float32Array;
  /** in order of time */
  readonly nearMisses: readonly NearMiss[];
  /** Where she is nearest to a hazard, the first of equals; null if the level has none. */
  readonly closest: NearMiss | null;
}

/** a distance below this is a near miss, px: the height of her box in the original game */
export const NEAR = 32;
/** several dips near the same hazard within this many ticks are one near miss */
const ONE_PASS = 30;
/** ticks for which the hazards that can be nearest are determined at once */
const STRETCH = 16;

/** Hazards that stay in place during the whole run, as arrays; and the others. */
interface Still {
  readonly count: number;
  readonly index: Int32Array;
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly radius: Float64Array;
  /** output: px from her to the rim of each */
  readonly rims: Float64Array;
  readonly others: readonly number[];
}

function sortOut(hazards: Hazards): Still {
  const circle = new Float64Array(3);
  const all = Array.from({ length: hazards.count }, (_, i) => i);
  // an alien that explodes at the very first moment has no position
  const index = Int32Array.from(all.filter((i) => hazards.isStill(i) && hazards.at(i, 0, circle)));
  const [x, y, radius, rims] = [0, 1, 2, 3].map(() => new Float64Array(index.length));
  for (const [k, i] of index.entries()) {
    hazards.at(i, 0, circle);
    [x[k], y[k], radius[k]] = circle;
  }
  return { count: index.length, index, x, y, radius, rims, others: all.filter((i) => !hazards.isStill(i)) };
}

/** Her largest distance between `from` and `to` from where she is at `from`, px. */
function strayFrom(way: Way, from: number, to: number): number {
  const { states } = way;
  let most = 0;
  for (let k = from + 1; k < to; k++) {
    const dx = states[STATE_SIZE * k] - states[STATE_SIZE * from];
    const dy = states[STATE_SIZE * k + 1] - states[STATE_SIZE * from + 1];
    most = Math.max(most, dx * dx + dy * dy);
  }
  return Math.sqrt(most);
}

/** The hazards that can be nearest within [from, to): all moving ones, and those at rest that the bounds allow. */
function candidates({ box }: Scene, way: Way, from: number, to: number, still: Still, into: number[]): void {
  into.length = 0;
  const stray = strayFrom(way, from, to);
  const x = way.states[STATE_SIZE * from];
  const y = way.states[STATE_SIZE * from + 1];
  const leastHalf = Math.min(box.halfWidth, box.halfHeight);
  let bound = Number.POSITIVE_INFINITY;
  const { count, rims } = still;
  for (let k = 0; k < count; k++) {
    const dx = still.x[k] - x;
    const dy = still.y[k] - y;
    const rim = Math.sqrt(dx * dx + dy * dy) - still.radius[k];
    rims[k] = rim;
    bound = Math.min(bound, rim - leastHalf + stray);
  }
  for (let k = 0; k < count; k++) if (rims[k] - box.halfDiagonal - stray <= bound) into.push(still.index[k]);
  into.push(...still.others);
}

/** Clearance and speed along a trajectory, and its near misses. */
export function marginsOf(scene: Scene, way: Way): Margins {
  const { count, states } = way;
  const gap = new Float32Array(count).fill(Number.POSITIVE_INFINITY);
  const speed = new Float32Array(count);
  const whose = new Int32Array(count).fill(-1);
  const hazards = new Hazards(scene, way);
  const still = sortOut(hazards);
  const circle = new Float64Array(3);
  const near: number[] = [];
  for (let from = 0; from < count; from += STRETCH) {
    const to = Math.min(count, from + STRETCH);
    if (hazards.count > 0) candidates(scene, way, from, to, still, near);
    for (let k = from; k < to; k++) {
      const o = STATE_SIZE * k;
      speed[k] = Math.hypot(states[o + 2], states[o + 3]);
      for (const i of near) {
        if (!hazards.at(i, k, circle)) continue;
        const found = boxCircleGap(
          scene.box,
          circle[0] - states[o],
          circle[1] - states[o + 1],
          states[o + 4],
          states[o + 5],
          circle[2],
        );
        if (found >= gap[k]) continue;
        gap[k] = found;
        whose[k] = i;
      }
    }
  }
  return { gap, speed, nearMisses: nearMissesOf(gap, whose, hazards), closest: closestOf(gap, whose, hazards) };
}

function closestOf(gap: Float32Array, whose: Int32Array, hazards: Hazards): NearMiss | null {
  let tick = 0;
  for (let k = 1; k < gap.length; k++) if (gap[k] < gap[tick]) tick = k;
  return gap.length === 0 || whose[tick] < 0 ? null : { tick, gap: gap[tick], ...hazards.nameOf(whose[tick]) };
}

function nearMissesOf(gap: Float32Array, whose: Int32Array, hazards: Hazards): NearMiss[] {
  const misses: NearMiss[] = [];
  let last = -1;
  for (let k = 0; k < gap.length; k++) {
    const isDip = gap[k] < NEAR && (k === 0 || gap[k] <= gap[k - 1]) && (k === gap.length - 1 || gap[k] < gap[k + 1]);
    if (!isDip) continue;
    const miss = { tick: k, gap: gap[k], ...hazards.nameOf(whose[k]) };
    const before = misses[misses.length - 1];
    if (before !== undefined && last === whose[k] && k - before.tick <= ONE_PASS) {
      if (miss.gap < before.gap) misses[misses.length - 1] = miss;
    } else misses.push(miss);
    last = whose[k];
  }
  return misses;
}

/** An object that is deadly to touch. */
interface Hazard {
  readonly kind: 'nova' | 'asteroid' | 'alien';
  /** index in the level's list of that kind */
  readonly index: number;
}

/** All hazards in one numbering: novae, hot asteroids, aliens; and their positions at a tick. */
class Hazards {
  readonly count: number;
  private readonly hot: number;

  constructor(
    private readonly scene: Scene,
    private readonly way: Way,
  ) {
    this.hot = scene.targets.count - scene.coldCount;
    this.count = scene.novae.count + this.hot + scene.aliens.count;
  }

  nameOf(i: number): Hazard {
    const { novae, targets, coldCount } = this.scene;
    if (i < novae.count) return { kind: 'nova', index: novae.index[i] };
    if (i < novae.count + this.hot) return { kind: 'asteroid', index: targets.index[coldCount + i - novae.count] };
    return { kind: 'alien', index: i - novae.count - this.hot };
  }

  /** Writes x, y, radius of hazard `i` at a tick. @returns whether it still exists */
  at(i: number, tick: number, out: Float64Array): boolean {
    const { scene, way, hot } = this;
    const { novae, targets, coldCount, aliens } = scene;
    if (i < novae.count) {
      out[0] = novae.x[i];
      out[1] = novae.y[i];
      out[2] = novae.r[i];
      return true;
    }
    if (i < novae.count + hot) {
      const t = coldCount + i - novae.count;
      out[0] = targets.x[t];
      out[1] = targets.y[t];
      if (way.asteroids.count > 0) way.asteroids.read(targets.index[t], tick, out);
      out[2] = targets.r[t];
      return true;
    }
    const alien = i - novae.count - hot;
    way.aliens.read(alien, tick, out);
    const isThere = out[2] !== 0;
    out[2] = aliens.r[alien];
    return isThere;
  }

  /** Whether it never moves during the run. */
  isStill(i: number): boolean {
    const { scene, way, hot } = this;
    const { novae, targets, coldCount } = scene;
    if (i < novae.count) return true;
    if (i < novae.count + hot)
      return way.asteroids.count === 0 || !way.asteroids.stirs(targets.index[coldCount + i - novae.count]);
    return !way.aliens.stirs(i - novae.count - hot);
  }
}
