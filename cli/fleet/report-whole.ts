import type { CommandResult } from '../command.ts';
import { createStatusLine, exitCodeAfter } from '../io/index.ts';
import type { Destination } from '../reporters/index.ts';
import { doWhole } from './do-whole.ts';
import type { Json } from './job.ts';
import type { JobName } from './job-names.ts';
import { jobOf, type ReportOptions } from './jobs/index.ts';

/** What a set is done with. */
interface WholeOptions extends Omit<ReportOptions, 'withTimes'> {
  /** The largest number of threads. */
  readonly jobs: number;
  /** What the report depends on besides the results. */
  readonly reporting?: Json;
}

/**
 * Does files and packs one after the other, and reports. Memory does not grow with their number.
 * @param doing what is done, for people: `checked`
 */
export async function reportWhole(
  job: JobName,
  settings: object,
  files: readonly string[],
  destinations: readonly Destination[],
  doing: string,
  { jobs, reporting = {}, ...options }: WholeOptions,
): Promise<CommandResult> {
  const line = createStatusLine();
  const { records, remove, signal } = await doWhole(job, settings, files, {
    jobs,
    onProgress: (done) => line.show(`${doing}: ${done}`),
  }).finally(line.clear);
  if (signal !== null) {
    remove();
    return { exitCode: exitCodeAfter(signal) };
  }
  try {
    const report = await jobOf(job).report(records, reporting, destinations, { ...options, withTimes: true });
    return { ...report, end: remove };
  } catch (error) {
    remove();
    throw error;
  }
}
