export { useRunEnds } from './run-ends.ts';
