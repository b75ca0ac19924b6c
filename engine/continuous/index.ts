export { type Method, WHOLE_METHOD } from './method.ts';
export { EventRecorder, PieceRecorder } from './recording.ts';
export { ContinuousSimulation } from './simulation.ts';
