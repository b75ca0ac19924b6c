export { solveJob } from './job.ts';
