export { PieceRecorder } from './recording.ts';
export { ContinuousSimulation } from './simulation.ts';
