import { Failure, namedPath } from '../../io/index.ts';

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
