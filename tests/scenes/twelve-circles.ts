import { resolveLevel } from '../../schema/index.ts';
import type { BenchScene } from './scene.ts';

/**
 * A minute of play among 12 circles. Places are random with room between them. The script was found by a random search: it
 * keeps her moving, away from every centre and clear of every hazard, and the paths at 60 and 480 Hz stay within 30 px of each
 * other for the whole minute, so that accuracies and other engines can be compared to the end.
 */
export const TWELVE_CIRCLES: BenchScene = {
  name: 'twelve circles',
  what: 'a minute of play: 5 cold and 3 hot asteroids, 4 novae, 42 holds, no contact',
  seconds: 60,
  level: resolveLevel({
    version: 1,
    name: 'Twelve circles',
    astronaut: { x: 243, y: 148, vx: 40, vy: -2 },
    blackHole: { x: 700, y: 520 },
    asteroids: [
      { x: 424, y: 61, radius: 16 },
      { x: 637, y: 256, radius: 16 },
      { x: 289, y: 390, radius: 16 },
      { x: 248, y: 238, radius: 16 },
      { x: 634, y: 369, radius: 16 },
      { x: 629, y: 476, radius: 16, hot: true },
      { x: 171, y: 78, radius: 16, hot: true },
      { x: 83, y: 434, radius: 16, hot: true },
    ],
    novae: [
      { x: 415, y: 370, radius: 16 },
      { x: 141, y: 234, radius: 16 },
      { x: 179, y: 343, radius: 16 },
      { x: 610, y: 117, radius: 32 },
    ],
  }),
  // biome-ignore format: one script, read as a whole
  holds: [
    [34, 89], [138, 215], [243, 341], [385, 419], [442, 499], [545, 635], [687, 724], [742, 841], [877, 928], [944, 985],
    [1000, 1068], [1114, 1185], [1206, 1247], [1299, 1356], [1401, 1431], [1487, 1527], [1544, 1630], [1645, 1698],
    [1719, 1754], [1785, 1816], [1830, 1869], [1888, 1985], [2000, 2086], [2102, 2153], [2180, 2224], [2240, 2329],
    [2349, 2434], [2461, 2494], [2516, 2550], [2564, 2629], [2645, 2675], [2688, 2736], [2796, 2893], [2911, 2990],
    [3005, 3051], [3067, 3108], [3120, 3210], [3231, 3322], [3340, 3392], [3406, 3447], [3460, 3557], [3573, 3600],
  ],
};
