import { useEffect, useState } from 'react';
import { useLevel } from '../../core/context/index.ts';
import { keyAt, type ObjectKey } from '../../core/document/index.ts';
import { afterRest } from '../../core/panel/index.ts';

/** ms without a change before problems are looked for, which simulates every run */
const PAUSE = 300;

/** The problems of objects of the open level, by their keys; updated a moment after the last change. */
export function useProblems(): ReadonlyMap<ObjectKey, readonly string[]> {
  const { proof } = useLevel();
  const [found, setFound] = useState<ReadonlyMap<ObjectKey, readonly string[]>>(new Map());
  useEffect(() => {
    const look = () => {
      const { file, problems } = proof.proof();
      const byKey = new Map<ObjectKey, string[]>();
      for (const { pointer, message } of problems) {
        const key = keyAt(file, pointer);
        if (key !== null) byKey.set(key, [...(byKey.get(key) ?? []), message]);
      }
      setFound(byKey);
    };
    let forget = afterRest(PAUSE, look);
    const stop = proof.store.subscribe(() => {
      forget();
      forget = afterRest(PAUSE, look);
    });
    return () => {
      stop();
      forget();
    };
  }, [proof]);
  return found;
}
