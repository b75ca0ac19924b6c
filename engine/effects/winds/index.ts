export { enterWind, leaveWind } from './events.ts';
export { winds } from './winds.ts';
