import { useEffect, useRef, useState } from 'react';
import { useLevel } from '../context/index.ts';
import type { LiveProof } from '../proof/index.ts';

/**
 * A value derived from the live proof, updated at most once per `wait` ms: a panel need not render for every move of the
 * pointer. It is derived at the end of the wait, as the arrays of a proof are only valid until the next one.
 * @param pick stable between renders (`useCallback`, or defined outside the component)
 */
export function useThrottledProof<T>(pick: (proof: LiveProof) => T, wait = 100): T {
  const { proof } = useLevel();
  const [picked, setPicked] = useState(() => ({ pick, value: pick(proof.proof()) }));
  const timer = useRef<ReturnType<typeof setTimeout> | null>(null);
  useEffect(() => {
    const look = () => {
      timer.current = null;
      setPicked({ pick, value: pick(proof.proof()) });
    };
    const stop = proof.store.subscribe(() => {
      timer.current ??= setTimeout(look, wait);
    });
    look();
    return () => {
      stop();
      if (timer.current !== null) clearTimeout(timer.current);
      timer.current = null;
    };
  }, [pick, proof, wait]);
  return picked.pick === pick ? picked.value : pick(proof.proof());
}
