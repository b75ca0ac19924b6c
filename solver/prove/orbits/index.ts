export { followOrbits } from './follow.ts';
export { FINEST_ORBITS, MOST_ORBITS, mayOrbit, proveOrbits } from './prove-orbits.ts';
