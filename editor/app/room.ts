import { useSyncExternalStore } from 'react';

/**
 * What there is room for: panels on both sides of the canvas, or one panel at a time, beside the canvas where the page is low, below it where it is
 * narrow. Zoom makes a page small as well: 1440 x 900 at 200 % is 720 x 450.
 */
export type Room = 'wide' | 'beside' | 'below';

/** Less than this is left of a canvas between two sides. */
const wide = matchMedia('(min-width: 880px) and (min-height: 520px)');
/** From here on a canvas has 320 px beside a panel. */
const beside = matchMedia('(min-width: 600px) and (orientation: landscape)');

const read = (): Room => (wide.matches ? 'wide' : beside.matches ? 'beside' : 'below');

function subscribe(listener: () => void): () => void {
  const queries = [wide, beside];
  for (const query of queries) query.addEventListener('change', listener);
  return () => {
    for (const query of queries) query.removeEventListener('change', listener);
  };
}

/** The room of the page; the component follows it. */
export const useRoom = (): Room => useSyncExternalStore(subscribe, read);
