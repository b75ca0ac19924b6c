import { type Scene, type Simulation, STATE_SIZE, TICK } from '../../engine/index.ts';

// px: more than any accuracy errs along a straight line, so that what touches is never ruled out
const MARGIN = 0.5;

/**
 * Tells without simulating when coasting on can't reach the black hole: she flies a straight line as long as she meets no repulsor.
 * Conservative: `true` only means that it has to be tried.
 */
export interface CoastingFilter {
  mayReach(simulation: Simulation): boolean;
}

/** The filter for a scene. Under `arcade` the gun's pull acts for one more frame after a release, so the line is a narrow cone. */
export function coastingFilter(scene: Scene): CoastingFilter {
  const { blackHole } = scene.level;
  const { repulsors, rules, box } = scene;
  const drift = scene.accuracy.integrator === 'arcade' ? rules.pull * TICK : 0;
  const state = new Float64Array(STATE_SIZE);
  const meets = (x: number, y: number, reach: number): boolean => {
    const [px, py, vx, vy] = state;
    return meetsDisc(px - x, py - y, vx, vy, reach + MARGIN, drift);
  };
  return {
    mayReach(simulation) {
      simulation.readState(state);
      if (meets(blackHole.x, blackHole.y, blackHole.radius + box.halfDiagonal)) return true;
      for (let i = 0; i < repulsors.count; i++) if (meets(repulsors.x[i], repulsors.y[i], repulsors.r[i])) return true;
      return false;
    },
  };
}

/** Whether |d + v t| <= reach + drift t for some t >= 0. */
function meetsDisc(dx: number, dy: number, vx: number, vy: number, reach: number, drift: number): boolean {
  const c = dx * dx + dy * dy - reach * reach;
  if (c <= 0) return true;
  const a = vx * vx + vy * vy - drift * drift;
  const b = dx * vx + dy * vy - reach * drift;
  if (a <= 0) return drift > 0;
  return b < 0 && b * b >= a * c;
}
