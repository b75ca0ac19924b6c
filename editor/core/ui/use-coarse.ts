import { useSyncExternalStore } from 'react';

const coarse = matchMedia('(pointer: coarse)');

function subscribe(listener: () => void): () => void {
  coarse.addEventListener('change', listener);
  return () => coarse.removeEventListener('change', listener);
}

/** Whether the pointer is a finger; re-renders when that changes. */
export const useCoarse = (): boolean => useSyncExternalStore(subscribe, () => coarse.matches);

/** px that a finger can hit easily, in each direction */
export const FINGER = 44;
