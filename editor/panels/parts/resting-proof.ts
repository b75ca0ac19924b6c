import { useEffect, useState } from 'react';
import { useLevel } from '../../app/context.ts';
import type { LiveProof } from '../../proof/index.ts';

/**
 * What `pick` makes of the live proof once nothing has changed for so many ms: for what would cost a drag its frames.
 * @param pick kept between renders (outside of the component)
 */
export function useRestingProof<T>(pick: (proof: LiveProof) => T, rest: number): T {
  const { proof } = useLevel();
  const [seen, setSeen] = useState(() => ({ proof, value: pick(proof.proof()) }));
  useEffect(() => {
    let timer: ReturnType<typeof setTimeout> | undefined;
    const look = () => setSeen({ proof, value: pick(proof.proof()) });
    const later = () => {
      clearTimeout(timer);
      timer = setTimeout(look, rest);
    };
    later();
    const stop = proof.store.subscribe(later);
    return () => {
      stop();
      clearTimeout(timer);
    };
  }, [proof, pick, rest]);
  return seen.proof === proof ? seen.value : pick(proof.proof());
}
