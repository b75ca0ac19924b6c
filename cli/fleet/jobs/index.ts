import type { JobName } from '../job-names.ts';
import { checkJob } from './check/index.ts';
import type { JobKind } from './kind.ts';

const KINDS: Readonly<Record<JobName, JobKind>> = { check: checkJob };

/** @param name of a job, as a plan has it */
export const jobOf = (name: string): JobKind => KINDS[name as JobName];
