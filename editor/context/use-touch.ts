import { useSyncExternalStore } from 'react';

const touch = matchMedia('(hover: none) and (pointer: coarse)');

function subscribe(listener: () => void): () => void {
  touch.addEventListener('change', listener);
  return () => touch.removeEventListener('change', listener);
}

/** Whether the page is used by fingers alone: then nothing should speak of keys and wheels. */
export const useTouch = (): boolean => useSyncExternalStore(subscribe, () => touch.matches);
