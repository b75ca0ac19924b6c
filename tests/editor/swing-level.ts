import type { LevelFile } from '../../schema/index.ts';

/** Her path depends on the pull: at 39 px/s2 the run completes the level, from 41 on and below 37 it does not. */
export const SWING: LevelFile = {
  version: 1,
  name: 'First Swing',
  astronaut: { x: 500, y: 760, vx: 0, vy: -60 },
  blackHole: { x: 830, y: 510 },
  asteroids: [{ id: 'bjzg', x: 600, y: 620, radius: 32 }],
  runs: [{ name: 'solution', holds: [[150, 435]] }],
};
