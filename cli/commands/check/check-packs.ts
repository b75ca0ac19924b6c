import type { CheckSettings } from '../../check/index.ts';
import type { CommandResult } from '../../command.ts';
import { Failure } from '../../failure.ts';
import { packFormat } from '../../packs/index.ts';
import { createStatusLine } from '../../progress.ts';
import type { Destination } from '../../reporters/index.ts';
import type { EditorLink } from '../../show-failure/index.ts';
import { namedPath } from '../../shown-path.ts';
import { exitCodeAfter } from '../../signals.ts';

/** The first of the files that is a pack; undefined if none is. */
export const firstPack = (files: readonly string[]): string | undefined => files.find((file) => packFormat(file) !== null);

/** Options that follow single files. */
export interface OfFiles {
  readonly changed?: unknown;
  readonly updateLock?: true;
  readonly bail?: number;
  readonly watch?: true;
  /** The lock that the options or the configuration choose. */
  readonly lock: string | null;
}

/** @throws Failure if an option is given that only a check of single files has */
export function refuseForPacks(pack: string, { changed, updateLock, bail, watch, lock }: OfFiles): void {
  const option =
    changed !== undefined ? '--changed' : updateLock ? '--update-lock' : watch ? '--watch' : bail !== undefined ? '--bail' : null;
  const given = option ?? (lock === null ? null : `the lock ${namedPath(lock)}`);
  if (given === null) return;
  const advice = option === null ? 'check packs with --no-lock' : `leave ${option} out, or unpack it`;
  throw new Failure(`${namedPath(pack)} is a pack, and ${given} is for level files: ${advice}`);
}

/** Checks files and packs one after the other; memory does not grow with their number. */
export async function checkPacks(
  files: readonly string[],
  settings: CheckSettings,
  reporting: Record<string, unknown>,
  destinations: readonly Destination[],
  { jobs, quiet, linkTo }: { readonly jobs: number; readonly quiet?: boolean; readonly linkTo: EditorLink | null },
): Promise<CommandResult> {
  // most checks have no packs
  const { doWhole, jobOf } = await import('../../fleet/index.ts');
  const line = createStatusLine();
  const { records, remove, signal } = await doWhole('check', settings, files, {
    jobs,
    onProgress: (done) => line.show(`checked: ${done}`),
  }).finally(line.clear);
  if (signal !== null) {
    remove();
    return { exitCode: exitCodeAfter(signal) };
  }
  try {
    const report = await jobOf('check').report(records, reporting, destinations, { quiet, linkTo, withTimes: true });
    return { ...report, end: remove };
  } catch (error) {
    remove();
    throw error;
  }
}
