export { meetTarget, passCentre, switchTarget } from './events.ts';
export { gun } from './gun.ts';
export { recordTarget } from './target.ts';
