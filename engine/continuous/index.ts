export { type EffectWork, EventRecorder, methodWith, PieceRecorder, WHOLE_METHOD, workByEffect } from './recording.ts';
export { ContinuousSimulation, type Method } from './simulation.ts';
