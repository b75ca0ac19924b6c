import { useEffect } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../core/context/index.ts';

/** Sets an attribute of the page to the user's choice or, without one, to the system's. */
function follow(query: string, wanted: (matches: boolean) => string, name: string): () => void {
  const media = matchMedia(query);
  const apply = () => document.documentElement.setAttribute(name, wanted(media.matches));
  apply();
  media.addEventListener('change', apply);
  return () => media.removeEventListener('change', apply);
}

/** Sets the theme and the amount of motion as `data-theme` and `data-motion` of the page. */
export function useTheme(): void {
  const { settings } = useEditor();
  const theme = useStore(settings, (state) => state.theme);
  const reduceMotion = useStore(settings, (state) => state.reduceMotion);
  useEffect(
    () =>
      follow('(prefers-color-scheme: light)', (light) => (theme === 'system' ? (light ? 'light' : 'dark') : theme), 'data-theme'),
    [theme],
  );
  useEffect(
    () =>
      follow(
        '(prefers-reduced-motion: reduce)',
        (less) => ((reduceMotion === 'system' ? less : reduceMotion === 'yes') ? 'less' : 'full'),
        'data-motion',
      ),
    [reduceMotion],
  );
}
