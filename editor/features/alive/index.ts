export { AliveStatus } from './AliveStatus.tsx';
export { AliveToggle } from './AliveToggle.tsx';
export { type AliveState, aliveOf } from './alive-state.ts';
export { ALIVE_KEY, keepAlive } from './keep-alive.ts';
