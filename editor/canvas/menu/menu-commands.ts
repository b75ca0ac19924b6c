import type { Command } from '../../core/commands/index.ts';
import { objectsOf } from '../../core/document/index.ts';
import type { Crosshair } from '../crosshair/index.ts';
import type { PointerContext } from '../pointer/index.ts';
import { isInView, type Point, toScreen } from '../view.ts';

/** The place that keys mean: the crosshair, else the selected object, else the middle of the view. */
export function placeMeant(context: PointerContext, crosshair: Crosshair): Point {
  const view = context.view();
  if (crosshair.isShown()) return crosshair.place();
  const [key] = context.selection.keys();
  const object = key === undefined ? undefined : objectsOf(context.document.file()).get(key)?.object;
  return object !== undefined && isInView(view, object) ? object : { x: view.x, y: view.y };
}

/** Opens the menu by key. */
export function menuCommands(context: PointerContext, crosshair: Crosshair): readonly Command[] {
  return [
    {
      id: 'edit.menu',
      title: 'Menu of what is at the crosshair or selected',
      group: 'Edit',
      keys: ['Shift+F10', 'ContextMenu'],
      needs: () => (crosshair.hasFocus() ? null : 'go to the canvas first'),
      run() {
        const at = placeMeant(context, crosshair);
        context.openMenu(at, toScreen(context.view(), at));
      },
    },
  ];
}
