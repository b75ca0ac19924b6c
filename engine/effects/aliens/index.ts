// apart, so that a game without aliens need not load what they do
export { alienChase, alienExplosion } from './aliens.ts';
export { explosionsAtStart } from './explosions-at-start.ts';
