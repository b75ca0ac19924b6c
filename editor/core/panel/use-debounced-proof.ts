import { useEffect, useState } from 'react';
import { useLevel } from '../context/index.ts';
import type { LiveProof } from '../proof/index.ts';
import { afterRest } from './after-rest.ts';

/**
 * A value derived from the live proof once nothing has changed for `rest` ms, for values too costly during a drag.
 * @param pick stable between renders (defined outside the component)
 */
export function useDebouncedProof<T>(pick: (proof: LiveProof) => T, rest: number): T {
  const { proof } = useLevel();
  const [seen, setSeen] = useState(() => ({ proof, value: pick(proof.proof()) }));
  useEffect(() => {
    const look = () => setSeen({ proof, value: pick(proof.proof()) });
    let forget = afterRest(rest, look);
    const stop = proof.store.subscribe(() => {
      forget();
      forget = afterRest(rest, look);
    });
    return () => {
      stop();
      forget();
    };
  }, [proof, pick, rest]);
  return seen.proof === proof ? seen.value : pick(proof.proof());
}
