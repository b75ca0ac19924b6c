export { alienChase } from './chase.ts';
export { alienExplosion } from './explosion.ts';
export { explosionsAtStart } from './explosions-at-start.ts';
