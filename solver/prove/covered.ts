import { type Box, boxCircleGap, type WorkBudget } from '../../engine/index.ts';
import { type StandingCircle, standingCircles } from './blockers.ts';
import type { About, Blocker, Proof } from './proof.ts';
import { distance, surelyLess } from './rounding.ts';
import { px, subject, thing } from './say.ts';
import { CONTINUOUS, type Setting, type Thing } from './setting.ts';

/** Sets of poses smaller than this are not divided any further, px. */
const FINEST = 0.1;

/** The most sets of poses to examine. */
const MOST_POSES = 200_000;

/** The direction of the box's x axis, a unit vector. */
interface Turn {
  readonly cos: number;
  readonly sin: number;
}

/**
 * `covered`: every pose (place and angle) in which her box touches the object overlaps a hazard as well. The hazard then ends
 * the run earlier, or at the same instant, and at the same instant it counts before the black hole. `arcade` tests the black
 * hole first and is not covered.
 *
 * A mineral that is touched at the same instant does count, for example when a press turns her box into a hazard. For minerals,
 * therefore, her centre must lie where every angle of the box overlaps a hazard.
 *
 * The proof divides the set of poses recursively (branch and bound). A box moved by some px, or turned so that no corner moves
 * farther, changes its distance to a circle by no more than that. So one pose decides for all poses around it, and the
 * certificate is empty: the checker repeats the division by itself. Rests on the lemmas `way`, `reach`, `order`, `drift` and
 * `mouths`.
 */
export function proveCovered(setting: Setting, about: About, goal: Thing): Proof | null {
  const { level, jump, maxTime, rules, box } = setting;
  if (jump > 0 || !surelyLess(goal.touch, distance(goal, { x: 0, y: 0 }))) return null;
  // A wormhole may put her where she could not be otherwise, and a mineral touched there counts.
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
      `${subject(about)} is covered by ${names.join(', ')}: wherever her collision box of ${px(rules.boxWidth)} by ${px(rules.boxHeight)} touches it, the box touches a hazard first: ` +
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

  /** Whether every pose that touches the object overlaps a hazard. Half a turn does not change the box. */
  isWhole(): boolean {
    const { x, y, touch } = this.goal;
    const right = { cos: 1, sin: 0 };
    const down = { cos: 0, sin: 1 };
    return this.holds(x, y, touch, right, down) && this.holds(x, y, touch, down, { cos: -1, sin: 0 });
  }

  /** Whether this holds for the places of a square around (x, y) and the angles from `a` to `b`. */
  private holds(x: number, y: number, half: number, a: Turn, b: Turn): boolean {
    if (++this.poses > MOST_POSES) return false;
    // The distance that a corner moves when the box turns by a chord of 1.
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
    // The central pose is a counterexample, or so close to one that dividing further would not help.
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
