import { useSyncExternalStore } from 'react';

const touch = () => matchMedia('(hover: none) and (pointer: coarse)');

function subscribe(listener: () => void): () => void {
  const asked = touch();
  asked.addEventListener('change', listener);
  return () => asked.removeEventListener('change', listener);
}

/** Whether the page is used by touch only: then texts should not mention keys and wheels. */
export const useTouch = (): boolean => useSyncExternalStore(subscribe, () => touch().matches);
