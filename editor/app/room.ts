import { useSyncExternalStore } from 'react';

/**
 * What the page has room for: panels on both sides of the canvas, or one panel at a time, beside the canvas on low pages and
 * below it on narrow ones. Zoom shrinks a page as well: 1440 x 900 at 200 % is 720 x 450.
 */
export type Room = 'wide' | 'beside' | 'below';

/** Below this size, too little of the canvas is left between two sides. */
const wide = matchMedia('(min-width: 880px) and (min-height: 520px)');
/** From this width on, the canvas keeps 320 px beside a panel. */
const beside = matchMedia('(min-width: 600px) and (orientation: landscape)');

const read = (): Room => (wide.matches ? 'wide' : beside.matches ? 'beside' : 'below');

function subscribe(listener: () => void): () => void {
  const queries = [wide, beside];
  for (const query of queries) query.addEventListener('change', listener);
  return () => {
    for (const query of queries) query.removeEventListener('change', listener);
  };
}

/** The room of the page; the component re-renders when it changes. */
export const useRoom = (): Room => useSyncExternalStore(subscribe, read);
