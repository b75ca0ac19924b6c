import { spawnSync } from 'node:child_process';
import process from 'node:process';
import { Failure } from '../io/index.ts';
import type { SlurmJob } from './slurm.ts';

/** Slurm's own default of MaxArraySize. */
export const USUAL_ARRAY_SIZE = 1001;

/**
 * Submits a job.
 * @param what the job in messages
 * @returns its number
 * @throws Failure with the words of `sbatch` if it refuses
 */
export function submitJob({ args, script }: SlurmJob, what: string): string {
  const answer = ask('sbatch', args, script);
  if (answer === null) {
    throw new Failure(
      'gq submit slurm needs the command sbatch, and there is none in PATH: run it on a machine of the cluster from which jobs are submitted; gq submit slurm --dry-run prints the jobs for another machine',
    );
  }
  const id = /^(\d+)(?:;\S*)?$/m.exec(answer.output)?.[1];
  if (answer.ok && id !== undefined) return id;
  throw new Failure(
    `sbatch refused ${what}: ${answer.words === '' ? `it said nothing and ended with ${answer.ending}` : answer.words}`,
  );
}

/** The least number that a task may not have; null if there is no cluster to be asked. */
export function maxArraySize(): number | null {
  const answer = ask('scontrol', ['show', 'config'], '');
  const size = answer === null ? undefined : /^MaxArraySize\s*=\s*(\d+)/m.exec(answer.output)?.[1];
  return size === undefined ? null : Number(size);
}

interface Answer {
  readonly ok: boolean;
  readonly output: string;
  /** What a command says on both streams, on one line. */
  readonly words: string;
  /** An exit code or a signal. */
  readonly ending: string;
}

/** @returns null if there is no such command */
function ask(command: string, args: readonly string[], input: string): Answer | null {
  const { status, signal, stdout, stderr, error } = spawnSync(command, args, {
    input,
    encoding: 'utf8',
    windowsHide: true,
    env: { ...process.env, LC_ALL: 'C' },
  });
  // a command that does not read its input is no error
  if (error !== undefined && (error as NodeJS.ErrnoException).code !== 'EPIPE') {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return null;
    throw new Failure(`${command} can't be run: ${error.message}`);
  }
  const words = `${stderr}\n${stdout}`.split('\n').map((line) => line.trim());
  return {
    ok: status === 0,
    output: stdout,
    words: words.filter((line) => line !== '').join('; '),
    ending: `${signal ?? `exit code ${status}`}`,
  };
}
