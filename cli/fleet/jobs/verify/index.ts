export { verifyJob } from './job.ts';
