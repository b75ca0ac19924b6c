export { EventRecorder, PieceRecorder, WHOLE_METHOD } from './recording.ts';
export { ContinuousSimulation, type Method } from './simulation.ts';
