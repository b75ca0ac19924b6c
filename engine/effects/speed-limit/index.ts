export { freeAxis, holdAxis } from './events.ts';
export { speedLimit } from './speed-limit.ts';
