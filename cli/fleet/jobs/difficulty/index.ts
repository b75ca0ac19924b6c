export { difficultyJob } from './job.ts';
