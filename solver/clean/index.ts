export { type Cleaned, type CleanOptions, cleanRun } from './clean-run.ts';
