export { useProblemCount } from './use-problems.ts';
