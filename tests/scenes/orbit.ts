import { type LevelFile, resolveLevel } from '../../schema/index.ts';
import type { BenchScene } from './scene.ts';

/**
 * The file of a level in which she swings around the first of 8 cold asteroids, between about 55 and 110 px from its centre,
 * always nearest to it. 4 novae are away from her path; there are 12 circles in all.
 */
export const ORBIT_FILE: LevelFile = {
  version: 1,
  name: 'Orbit',
  astronaut: { x: 110, y: 0, vx: 0, vy: 36 },
  blackHole: { x: 900, y: 900 },
  asteroids: [
    { x: 0, y: 0, radius: 16 },
    { x: 410, y: 30, radius: 32 },
    { x: 300, y: 310, radius: 16 },
    { x: -20, y: 420, radius: 16 },
    { x: -310, y: 290, radius: 32 },
    { x: -430, y: -10, radius: 16 },
    { x: -290, y: -300, radius: 16 },
    { x: 20, y: -420, radius: 32 },
  ],
  novae: [
    { x: 560, y: 200, radius: 32 },
    { x: 180, y: 560, radius: 16 },
    { x: -540, y: 190, radius: 16 },
    { x: 190, y: -580, radius: 32 },
  ],
};

/**
 * A minute around one asteroid with the gun held all the time: smooth and not chaotic, so errors are only those of the
 * integrator.
 */
export const ORBIT: BenchScene = {
  name: 'orbit',
  what: 'a minute around one of 12 circles, held throughout: smooth, no target change',
  level: resolveLevel(ORBIT_FILE),
  holds: [[0, 3600]],
  seconds: 60,
};
