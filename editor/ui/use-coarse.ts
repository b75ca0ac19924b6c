import { useSyncExternalStore } from 'react';

const coarse = matchMedia('(pointer: coarse)');

function subscribe(listener: () => void): () => void {
  coarse.addEventListener('change', listener);
  return () => coarse.removeEventListener('change', listener);
}

/** Whether a finger is what points here; the component follows it. */
export const useCoarse = (): boolean => useSyncExternalStore(subscribe, () => coarse.matches);

/** px that a finger hits with ease, each way */
export const FINGER = 44;
