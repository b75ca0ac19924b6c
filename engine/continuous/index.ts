export { type EffectWork, EventRecorder, PieceRecorder, WHOLE_METHOD, workByEffect } from './recording.ts';
export { ContinuousSimulation, type Method } from './simulation.ts';
