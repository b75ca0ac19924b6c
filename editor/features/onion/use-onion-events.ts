import { useEffect } from 'react';
import { followInput } from './last-input.ts';
import type { OnionSession } from './watch-onion.ts';

const MODIFIERS: readonly string[] = ['Shift', 'Alt', 'Control', 'Meta'];

/** Tells the session what the user does anywhere on the page. */
export function useOnionEvents(onion: OnionSession): void {
  useEffect(() => {
    const stopping = new AbortController();
    followInput(stopping.signal);
    // before other listeners, as some of them stop the event
    const options = { capture: true, signal: stopping.signal };
    const onKey = ({ key }: KeyboardEvent) => {
      if (!MODIFIERS.includes(key)) onion.dismiss();
    };
    // after other listeners, which end the gesture
    const onUp = () => void setTimeout(onion.released);
    window.addEventListener('pointerdown', onion.dismiss, options);
    window.addEventListener('keydown', onKey, options);
    for (const type of ['pointerup', 'pointercancel', 'keyup', 'blur'] as const) window.addEventListener(type, onUp, options);
    return () => stopping.abort();
  }, [onion]);
}
