export { hotAsteroids } from './hot-asteroids.ts';
export { novae } from './novae.ts';
