import { type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';

/** A level with one asteroid, two minerals and a black hole, plus the given properties. */
export const level = (more: Partial<LevelFile>): Level =>
  resolveLevel({
    version: 1,
    name: 'fine',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 300, y: 0 },
    asteroids: [{ x: 150, y: 0, radius: 16 }],
    minerals: [
      { x: 90, y: 60 },
      { x: 900, y: 0 },
    ],
    ...more,
  });
export const at = (x: number, y: number, radius = 16) => ({ x, y, radius });
const ring = (x: number, y: number, r: number) =>
  Array.from({ length: 17 }, (_, i) => at(x + r * Math.cos((i * Math.PI) / 8.5), y + r * Math.sin((i * Math.PI) / 8.5)));

/** An impossible level for each kind of proof, and for the special cases in {@link ALSO}. */
export const LEVELS: Record<string, Level> = {
  'nothing-in-range': level({ astronaut: { x: -150, y: 0 } }),
  'starts-in-hazard': level({ novae: [at(400, 400), at(10, 20)] }),
  'out-of-range': level({ blackHole: { x: 900, y: 0 }, asteroids: [at(150, 0), at(900, 0), at(200, 300)], recoil: true }),
  enclosed: level({ novae: ring(300, 0, 70), asteroids: [at(150, 0), at(0, 160)] }),
  'line-trap': level({ novae: [at(220, 0)] }),
  covered: level({ novae: [at(306, 0, 22), at(294, 0, 22)], asteroids: [at(150, 0), at(0, 160)] }),
  doomed: level({ astronaut: { x: 0, y: 0, vx: -60 }, novae: [at(-60, 0, 32), at(-60, 60, 32), at(-60, -60, 32)], recoil: true }),
  flowpipe: level({ astronaut: { x: 0, y: 0, vx: 60 }, aliens: [{ x: 70, y: 5 }] }),
  orbits: level({ astronaut: { x: 0, y: 0, vy: -80 }, blackHole: { x: 180, y: 60 }, asteroids: [at(120, -140)] }),
};

/** Further levels for a kind, by what is special about their proof. */
export const ALSO: Record<string, [code: string, of: Level]> = {
  'line-trap with a dead end': [
    'line-trap',
    level({ asteroids: [at(60, 0), at(160, 60)], novae: [at(-60, 0), at(176, 0, 32), at(150, 66, 32)] }),
  ],
  'line-trap with recoil': [
    'line-trap',
    level({ recoil: true, asteroids: [at(60, 0), at(0, 120)], novae: [at(150, 0), at(-60, 0)] }),
  ],
};
for (const [name, [, of]] of Object.entries(ALSO)) LEVELS[name] = of;
