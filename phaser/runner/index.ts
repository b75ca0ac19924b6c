export type { Area, CameraMode, InputOptions, RunnerOptions } from './options.ts';
export { requirePhaser } from './require.ts';
export { createRunner, type Runner } from './runner.ts';
