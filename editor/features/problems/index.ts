export { Problems } from './Problems.tsx';
export { useProblemCount } from './use-problems.ts';
