export type { Method } from './method.ts';
export { EventRecorder, PieceRecorder } from './recording.ts';
export { ContinuousSimulation } from './simulation.ts';
export { WHOLE_METHOD } from './whole-method.ts';
