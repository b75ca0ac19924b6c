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

// halfway between two frames the hind corner of her box brushes a speck: a test at frames jumps over that
export const SPECK: LevelFile = {
  version: 1,
  name: 'Past a speck',
  astronaut: { x: 0, y: 0, vx: 990, vy: 500 },
  blackHole: { x: 1980, y: 1000 },
  range: 5000,
  asteroids: [{ x: 0, y: 900, radius: 16 }],
  novae: [{ x: 97.04, y: 70.59, radius: 0.5 }],
  runs: [{ name: 'drift', holds: [] }],
};
