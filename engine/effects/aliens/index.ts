export { alienChase } from './chase.ts';
export { explode, fallAsleep, touchAlien, wake } from './events.ts';
export { alienExplosion } from './explosion.ts';
export { explosionsAtStart } from './explosions-at-start.ts';
