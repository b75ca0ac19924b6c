import type { JobName } from '../job.ts';
import { checkJob } from './check/index.ts';
import { difficultyJob } from './difficulty/index.ts';
import type { JobKind } from './kind.ts';
import { solveJob } from './solve/index.ts';
import { verifyJob } from './verify/index.ts';

const KINDS: Readonly<Record<JobName, JobKind>> = {
  check: checkJob,
  solve: solveJob,
  difficulty: difficultyJob,
  verify: verifyJob,
};

export type { ReportOptions } from './kind.ts';

/** @param name of a job, as a plan has it */
export const jobOf = (name: string): JobKind => KINDS[name as JobName];
