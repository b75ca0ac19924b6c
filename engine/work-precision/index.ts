export * from './cost.ts';
export * from './measure.ts';
