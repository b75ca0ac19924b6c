import type { LevelFile } from '../../schema/index.ts';

/** She swings past a nova: at `precise` just clear of it, at `arcade` into it; with a stronger gun, or little work, not to the end. */
export const GRAZE: LevelFile = {
  version: 1,
  name: 'Graze',
  astronaut: { x: 0, y: 0, vx: 70 },
  blackHole: { x: 330, y: -40, radius: 50 },
  range: 380,
  asteroids: [{ id: 'a1', x: 160, y: -70, radius: 18 }],
  novae: [{ id: 'n1', x: 130, y: 13.75, radius: 9 }],
  runs: [{ name: 'run', holds: [[0, 140]] }],
};

/** She drifts into the black hole, which takes 84 s: the gun pulls at nothing, since the only asteroid is hot. */
export const SLOW: LevelFile = {
  version: 1,
  name: 'Slow',
  astronaut: { x: 0, y: 0, vx: 2 },
  blackHole: { x: 220, y: 0, radius: 40 },
  range: 400,
  asteroids: [{ id: 'a1', x: 100, y: -160, radius: 16, hot: true }],
  runs: [{ name: 'run', holds: [[1, 3]] }],
};
