export * from './level.ts';
export { resolveLevel } from './resolve.ts';
