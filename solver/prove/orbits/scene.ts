import { standingCircles } from '../blockers.ts';
import type { About, Blocker } from '../proof.ts';
import { mouthDiscs } from '../rims.ts';
import type { Setting, Thing } from '../setting.ts';

/** A place, px from the start. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

/** A disc of radius r px. */
export interface Spot extends Place {
  readonly r: number;
}

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
