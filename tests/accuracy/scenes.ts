import { type LevelFile, resolveLevel } from '../../schema/index.ts';

/** She swings around one asteroid, held for ten seconds: smooth, no target change, no close pass, nothing to touch. */
export const SWING_FILE: LevelFile = {
  version: 1,
  name: 'Swing',
  astronaut: { x: 110, y: 0, vx: 0, vy: 36 },
  blackHole: { x: 900, y: 900 },
  asteroids: [{ x: 0, y: 0, radius: 16 }],
  runs: [{ name: 'swing', holds: [[0, 600]] }],
};

export const SWING = resolveLevel(SWING_FILE);
