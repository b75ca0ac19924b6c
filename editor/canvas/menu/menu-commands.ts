import type { Command } from '../../commands/index.ts';
import { objectsOf } from '../../document/index.ts';
import type { Crosshair } from '../crosshair/index.ts';
import type { PointerContext } from '../pointer/index.ts';
import { isInView, type Point, toScreen } from '../view.ts';

/** Opens the menu by key: at the crosshair, else at the selected object, else in the middle of the view. */
export function menuCommands(context: PointerContext, crosshair: Crosshair): readonly Command[] {
  const place = (): Point => {
    const view = context.view();
    if (crosshair.isShown()) return crosshair.place();
    const [key] = context.selection.keys();
    const object = key === undefined ? undefined : objectsOf(context.document.file()).get(key)?.object;
    return object !== undefined && isInView(view, object) ? object : { x: view.x, y: view.y };
  };
  return [
    {
      id: 'edit.menu',
      title: 'Menu of what is at the crosshair or selected',
      group: 'Edit',
      keys: ['Shift+F10', 'ContextMenu'],
      needs: () => (crosshair.hasFocus() ? null : 'go to the canvas first'),
      run() {
        const at = place();
        context.openMenu(at, toScreen(context.view(), at));
      },
    },
  ];
}
