import { type RefObject, useEffect } from 'react';
import { useEditor } from '../../core/context/index.ts';

/** While an element is shown, a gamepad moves the focus among its buttons with the directions and presses one with A. */
export function usePadChoice(element: RefObject<HTMLElement | null>): void {
  const { commands } = useEditor();
  useEffect(() => {
    const buttons = () => [...(element.current?.querySelectorAll('button') ?? [])];
    const move = (by: number) => {
      const all = buttons();
      const now = all.indexOf(document.activeElement as HTMLButtonElement);
      all[now < 0 ? 0 : (now + by + all.length) % all.length]?.focus();
    };
    const press = () =>
      buttons()
        .find((button) => button === document.activeElement)
        ?.click();
    const pad = { group: 'Play', mode: 'play', hidden: true } as const;
    return commands.register([
      { ...pad, id: 'play.choose-previous', title: 'Previous button', pad: 'Left', run: () => move(-1) },
      { ...pad, id: 'play.choose-next', title: 'Next button', pad: 'Right', run: () => move(1) },
      { ...pad, id: 'play.choose', title: 'Press the button', pad: 'A', run: press },
    ]);
  }, [commands, element]);
}
