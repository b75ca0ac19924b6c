export { enterMouth, leaveMouth } from './events.ts';
export { wormholes } from './wormholes.ts';
