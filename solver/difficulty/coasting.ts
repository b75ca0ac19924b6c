import { type Circles, EFFECTS, type Scene, type Simulation, STATE_SIZE, TICK } from '../../engine/index.ts';

// px; more than the error of any accuracy along a straight line, so that a contact is never ruled out.
const MARGIN = 0.5;

/**
 * Tells without a simulation that drifting on cannot reach the black hole. She flies on a straight line until she meets a
 * disc in which an effect acts on her.
 */
export interface CoastingFilter {
  /**
   * Whether drifting on from the state of a simulation may reach the black hole. `false` is certain; `true` means that it has to be
   * simulated.
   */
  mayReach(simulation: Simulation): boolean;
}

/**
 * Creates the filter for a scene. In `arcade` the pull acts for one more frame after a release, so the line becomes a narrow
 * cone.
 */
export function coastingFilter(scene: Scene): CoastingFilter {
  const { blackHole } = scene.level;
  const { rules, box } = scene;
  const discs = turningDiscs(scene);
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
      for (const { count, x, y, r } of discs) for (let i = 0; i < count; i++) if (meets(x[i], y[i], r[i])) return true;
      return false;
    },
  };
}

/** Discs in which something other than the gun may turn or move her. */
function turningDiscs(scene: Scene): Circles[] {
  const frames = EFFECTS.flatMap((effect) => (effect.frame && effect.calledFor(scene.level).called ? [effect.frame] : []));
  return frames.map((frame) => frame.discs(scene));
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
