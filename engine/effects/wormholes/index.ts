export { wormholes } from './wormholes.ts';
