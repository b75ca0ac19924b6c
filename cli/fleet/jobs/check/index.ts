export { checkJob } from './job.ts';
