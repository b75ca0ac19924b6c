export { meetTarget, passCentre, switchTarget } from './events.ts';
export { gun } from './gun.ts';
export { holdOnLine } from './meeting.ts';
export { isTiny, skipOrbits } from './orbits.ts';
export { recordTarget } from './target.ts';
