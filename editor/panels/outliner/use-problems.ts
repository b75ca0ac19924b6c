import { useAtRest } from '../../ask/index.ts';
import { useLevel } from '../../context/index.ts';
import { keyAt, type ObjectKey } from '../../document/index.ts';
import type { LiveProof } from '../../proof/index.ts';

/** ms without a change before problems are looked for, which simulates every run */
const PAUSE = 300;

const NONE: ReadonlyMap<ObjectKey, readonly string[]> = new Map();

function byObject({ file, problems }: LiveProof): ReadonlyMap<ObjectKey, readonly string[]> {
  const byKey = new Map<ObjectKey, string[]>();
  for (const { pointer, message } of problems) {
    const key = keyAt(file, pointer);
    if (key !== null) byKey.set(key, [...(byKey.get(key) ?? []), message]);
  }
  return byKey;
}

/** The problems of objects of the open level, by their keys; updated a moment after the last change. */
export const useProblems = (): ReadonlyMap<ObjectKey, readonly string[]> =>
  useAtRest(useLevel().proof.store, byObject, PAUSE, NONE);
