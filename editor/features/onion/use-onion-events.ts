import { useEffect } from 'react';
import { useEditor } from '../../core/context/index.ts';
import { followInput } from './last-input.ts';
import { COMPARE_KEY, type OnionSession } from './watch-onion.ts';

const MODIFIERS: readonly string[] = ['Shift', 'Alt', 'Control', 'Meta'];

/** Tells the session what the user does anywhere on the page, and registers its command. */
export function useOnionEvents(onion: OnionSession): void {
  const { commands } = useEditor();
  useEffect(
    () =>
      commands.register([
        {
          id: 'view.before',
          title: 'Compare with before the last change',
          group: 'View',
          keys: [COMPARE_KEY],
          needs: onion.needs,
          run: onion.toggle,
        },
      ]),
    [commands, onion],
  );
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
