import type { Place } from '../../../schema/basics/index.ts';
import { standingCircles } from '../blockers.ts';
import type { About, Blocker } from '../proof.ts';
import { mouthDiscs, type Setting, type Spot, type Thing } from '../setting.ts';

/** What she may come upon. */
export interface OrbitScene {
  /** The asteroids, each with its acceleration by recoil, px/s². */
  readonly rocks: readonly (Place & { readonly k: number; readonly radius: number })[];
  /** Discs in which her centre cannot be. */
  readonly hazards: readonly (Spot & { readonly of: Blocker })[];
  /** What ends a run at each asteroid; null if it is cold. */
  readonly own: readonly (Blocker | null)[];
  readonly fields: readonly Spot[];
  readonly winds: readonly (Spot & { readonly ax: number; readonly ay: number })[];
  readonly mouths: readonly Spot[];
  /** The object, with the radius at which she may touch it. */
  readonly goal: Spot;
}

export function orbitScene(setting: Setting, about: About, goal: Thing): OrbitScene {
  const { level, rules } = setting;
  const { x, y } = level.astronaut;
  return {
    rocks: level.asteroids.map((a) => ({
      x: a.x - x,
      y: a.y - y,
      k: level.recoil ? (1.01 * rules.recoil) / (2 * a.radius) : 0,
      radius: a.radius,
    })),
    hazards: standingCircles(setting, about).map((c) => ({ x: c.x, y: c.y, r: c.radius + setting.leastHalf, of: c.of })),
    own: level.asteroids.map((a, index) => (a.hot ? { kind: 'asteroid', index } : null)),
    fields: level.repulsors.map((c) => ({ x: c.x - x, y: c.y - y, r: c.radius })),
    winds: level.winds.map((c) => ({ x: c.x - x, y: c.y - y, r: c.radius, ax: c.ax, ay: c.ay })),
    mouths: mouthDiscs(level).map((c) => ({ x: c.x - x, y: c.y - y, r: c.radius })),
    goal: { x: goal.x, y: goal.y, r: goal.touch },
  };
}

/** Far more than the rounding error of a step, px and px/s. */
export const SLACK = 1e-6;

/** Far more than the rounding error of an angular momentum, px²/s. */
export const slackL = (L: number): number => 1e-4 + 1e-8 * Math.abs(L);
