export { followOrbits } from './follow.ts';
export { FINEST_ORBITS, MOST_ORBITS, proveOrbits } from './prove-orbits.ts';
