export { hotAsteroids, touchHot } from './hot-asteroids.ts';
export { novae, touchNova } from './novae.ts';
