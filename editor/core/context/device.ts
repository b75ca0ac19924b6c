import { useSyncExternalStore } from 'react';

// What the page is used with and how it looks: pointer, keyboard, theme.

/** A media query of the page, asked when it is first needed. */
export interface Media {
  readonly matches: () => boolean;
  readonly subscribe: (listener: () => void) => () => void;
}

export function mediaOf(query: string): Media {
  let known: MediaQueryList | null = null;
  const media = () => {
    known ??= matchMedia(query);
    return known;
  };
  return {
    matches: () => media().matches,
    subscribe(listener) {
      media().addEventListener('change', listener);
      return () => media().removeEventListener('change', listener);
    },
  };
}

/** Whether a media query matches; re-renders when that changes. */
export const useMedia = ({ subscribe, matches }: Media): boolean => useSyncExternalStore(subscribe, matches);

const TOUCH = mediaOf('(hover: none) and (pointer: coarse)');
const COARSE = mediaOf('(pointer: coarse)');

/** Whether the page is used by touch only: then texts should not mention keys and wheels. */
export const useTouch = (): boolean => useMedia(TOUCH);

/** Whether the pointer is a finger. */
export const useCoarse = (): boolean => useMedia(COARSE);

/** px that a finger can hit easily, in each direction */
export const FINGER = 44;

/** Whether keys are written as on a Mac. */
export const IS_MAC = /Mac|iP(hone|ad|od)/.test(globalThis.navigator?.userAgent ?? '');

function followTheme(listener: () => void): () => void {
  const observer = new MutationObserver(listener);
  observer.observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
  return () => observer.disconnect();
}

const readTheme = (): 'dark' | 'light' => (document.documentElement.dataset.theme === 'light' ? 'light' : 'dark');

/** The theme of the page; re-renders when it changes. */
export const usePageTheme = (): 'dark' | 'light' => useSyncExternalStore(followTheme, readTheme);
