import type { Command } from '../core/commands/index.ts';
import type { Crosshair } from './crosshair/index.ts';
import { clickAgain, hitsOf, type PointerContext } from './pointer/index.ts';

/** Reaches what lies below other objects. */
export function overlapCommands(context: PointerContext, crosshair: Crosshair): readonly Command[] {
  /** The crosshair, the place of the last click, or the selected object. */
  const place = () => {
    const last = context.clicks.getState();
    if (crosshair.isShown() || last === null) return crosshair.place();
    return last.place;
  };
  return [
    {
      id: 'edit.next-here',
      title: 'Select the next object at the same place',
      group: 'Edit',
      keys: ['j'],
      needs: () => (hitsOf(context, { place: place(), by: 'keys' }).length > 0 ? null : 'click on an object first'),
      run: () => clickAgain(context, place()),
    },
  ];
}
