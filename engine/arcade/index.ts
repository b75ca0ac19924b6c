export { FrameRecorder } from './recording.ts';
export { ArcadeSimulation } from './simulation.ts';
