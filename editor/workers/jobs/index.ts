// The list of all jobs: the page takes their records from it, a worker also how they are done.
export * from './accuracy.ts';
export * from './check.ts';
export * from './compare.ts';
export * from './difficulty.ts';
export * from './effects.ts';
export * from './fix.ts';
export * from './leeway.ts';
export * from './lost.ts';
export * from './mend.ts';
export * from './plays.ts';
export * from './retime.ts';
export * from './robustness.ts';
export * from './slack.ts';
export * from './solve.ts';
export * from './thumbnail.ts';
export * from './trajectory.ts';
