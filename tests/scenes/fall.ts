import { DEFAULT_RULES, resolveLevel } from '../../schema/index.ts';
import type { BenchScene } from './scene.ts';

const RANGE = 250;
const START = 200;

/** She falls from rest towards one asteroid: besides straight lines the only motion of the game with a closed form. */
export const FALL: BenchScene = {
  name: 'fall',
  what: 'from rest, 200 px from one asteroid, held; 2.5 s, before its centre',
  level: resolveLevel({
    version: 1,
    name: 'Fall',
    astronaut: { x: -START, y: 0 },
    blackHole: { x: 0, y: 2000 },
    range: RANGE,
    asteroids: [{ x: 0, y: 0, radius: 16 }],
  }),
  holds: [[0, 3600]],
  seconds: 2.5,
};

/**
 * Distance from the asteroid's centre of {@link FALL} at `time` (s), px: d = M - (M - d0) cosh(t sqrt(A / M)), from d'' = -A (1
 * - d / M).
 */
export const fallDistance = (time: number): number =>
  RANGE - (RANGE - START) * Math.cosh(time * Math.sqrt(DEFAULT_RULES.pull / RANGE));
