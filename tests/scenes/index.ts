export { FALL, fallDistance } from './fall.ts';
export { asteroidField } from './field.ts';
export { ORBIT, ORBIT_FILE } from './orbit.ts';
export type { BenchScene } from './scene.ts';
export { seeded } from './seeded.ts';
export { TWELVE_CIRCLES } from './twelve-circles.ts';
