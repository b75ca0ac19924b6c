export { type AliveState, aliveOf } from './alive-state.ts';
