import { compile, type Run, simulate } from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';

/** One of everything, two of some. */
export const FULL: LevelFile = {
  version: 1,
  name: 'One of everything',
  description: 'for pictures',
  astronaut: { x: 120, y: 420 },
  blackHole: { x: 760, y: 150 },
  asteroids: [
    { x: 250, y: 330, radius: 32 },
    { x: 420, y: 230, radius: 16 },
    { x: 600, y: 330, radius: 16, hot: true },
  ],
  novae: [{ x: 330, y: 420, radius: 32 }],
  repulsors: [{ x: 560, y: 440, radius: 48 }],
  aliens: [
    { x: 300, y: 120 },
    { x: 480, y: 60 },
  ],
  minerals: [
    { x: 330, y: 280 },
    { x: 480, y: 260 },
    { x: 640, y: 180 },
  ],
};

/** A fall straight through an asteroid and a mineral into the black hole. */
export const DROP: LevelFile = {
  version: 1,
  name: 'Drop',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 0, y: 260 },
  asteroids: [{ x: 0, y: 120, radius: 16 }],
  minerals: [
    { x: 5, y: 60 },
    { x: 200, y: 60 },
  ],
};

export const level = (file: LevelFile): Level => resolveLevel(file);

export const play = (file: LevelFile, holds: readonly Hold[], maxTime = 20): Run =>
  simulate(compile(level(file), 'arcade'), holds, { maxTime });

/** The number of elements of a kind in a picture. */
export const count = (svg: string, kind: string): number => svg.split(`data-kind="${kind}"`).length - 1;
