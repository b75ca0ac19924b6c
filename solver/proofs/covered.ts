import { type Box, boxCircleGap, type WorkBudget } from '../../engine/index.ts';
import { type StandingCircle, standingCircles } from './blockers.ts';
import type { About, Blocker, Proof } from './proof.ts';
import { distance, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { CONTINUOUS, type Setting, type Thing } from './setting.ts';

/** Poses nearer to each other than this aren't told apart, px. */
const FINEST = 0.1;

/** More sets of poses than this aren't looked at. */
const MOST_POSES = 200_000;

/** The direction of the box's short side, a unit vector. */
interface Turn {
  readonly cos: number;
  readonly sin: number;
}

/**
 * Wherever her box touches the thing, and however it is turned, it overlaps a hazard as well: then the hazard ended the run before, or in the
 * same instant, in which it wins. In `arcade` the black hole does. A mineral wins, too, over a hazard that a press turns her
 * into: there her centre must be where every turn of the box overlaps one.
 */
export function proveCovered(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, jump, maxTime, rules, box } = setting;
  if (jump > 0 || !surelyLess(goal.touch, distance(goal, { x: 0, y: 0 }))) return null;
  // she who comes out of a mouth may touch a mineral from where she can't be otherwise
  if (about.kind === 'mineral' && level.wormholes.length > 0) return null;
  const near = standingCircles(setting, about).filter((c) => distance(c, goal) < goal.touch + c.radius + box.halfDiagonal);
  if (near.length === 0) return null;
  const cover = new Cover(setting, goal, near, about.kind === 'mineral');
  if (!cover.isWhole()) return null;
  const names = [...cover.used].map((by) => (by.kind === 'range' ? '' : thing(by)));
  return {
    code: 'covered',
    about,
    reason:
      `${subject(about)} is covered by ${names.join(', ')}: wherever her box of ${px(rules.boxWidth)} by ${px(rules.boxHeight)} touches it, it touches a hazard before: ` +
      `move ${names.length > 1 ? 'one of them' : names[0]} away from it`,
    covers: CONTINUOUS,
    maxTime: level.recoil ? maxTime : null,
    certificate: { kind: 'covered' },
  };
}

class Cover {
  private readonly box: Box;
  private readonly leastHalf: number;
  private readonly budget: WorkBudget;
  private poses = 0;
  readonly used = new Set<Blocker>();

  constructor(
    { box, leastHalf, budget }: Setting,
    private readonly goal: Thing,
    private readonly hazards: readonly StandingCircle[],
    private readonly anyTurn: boolean,
  ) {
    this.box = box;
    this.leastHalf = leastHalf;
    this.budget = budget;
  }

  /** Whether every pose that touches the thing overlaps a hazard. The box looks the same after half a turn. */
  isWhole(): boolean {
    const { x, y, touch } = this.goal;
    const right = { cos: 1, sin: 0 };
    const down = { cos: 0, sin: 1 };
    return this.holds(x, y, touch, right, down) && this.holds(x, y, touch, down, { cos: -1, sin: 0 });
  }

  /** Whether it holds for the places of a square about (x, y) and the turns from `a` to `b`. */
  private holds(x: number, y: number, half: number, a: Turn, b: Turn): boolean {
    if (++this.poses > MOST_POSES) return false;
    // how far a corner moves when the box turns by a chord of 1
    const lever = this.box.halfDiagonal;
    const middle = between(a, b);
    const chord = Math.max(chordOf(middle, a), chordOf(middle, b));
    const reach = half * 1.41422 + lever * chord * 1.000001;
    const touch = boxCircleGap(this.box, this.goal.x - x, this.goal.y - y, middle.cos, middle.sin, this.goal.radius);
    if (surelyLess(reach, touch)) return true;
    this.budget.look(1 + this.hazards.length);
    let best = Number.POSITIVE_INFINITY;
    for (const hazard of this.hazards) {
      const depth = this.gap(hazard, x, y, middle);
      if (surelyLess(depth, this.anyTurn ? -half * 1.41422 : -reach)) {
        this.used.add(hazard.of);
        return true;
      }
      best = Math.min(best, depth);
    }
    // the pose in the middle is a counterexample, or as good as one
    if ((touch < 0 && best >= 0) || reach < FINEST) return false;
    if (half > lever * chord) {
      const h = half / 2;
      return [-h, h].every((dx) => [-h, h].every((dy) => this.holds(x + dx, y + dy, h, a, b)));
    }
    return this.holds(x, y, half, a, middle) && this.holds(x, y, half, middle, b);
  }

  private gap({ x: hx, y: hy, radius }: StandingCircle, x: number, y: number, { cos, sin }: Turn): number {
    const dx = hx - x;
    const dy = hy - y;
    return this.anyTurn
      ? Math.sqrt(dx * dx + dy * dy) - radius - this.leastHalf
      : boxCircleGap(this.box, dx, dy, cos, sin, radius);
  }
}

function between(a: Turn, b: Turn): Turn {
  const cos = a.cos + b.cos;
  const sin = a.sin + b.sin;
  const length = Math.sqrt(cos * cos + sin * sin);
  return { cos: cos / length, sin: sin / length };
}

function chordOf(a: Turn, b: Turn): number {
  return Math.sqrt((a.cos - b.cos) * (a.cos - b.cos) + (a.sin - b.sin) * (a.sin - b.sin));
}
