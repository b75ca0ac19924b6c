import { panBy } from '../view.ts';
import { hasMoved, type PointerContext, type PointerInput, type PointerState } from './state.ts';

/** Moves the view; the right button opens the menu of the place if it is released where it was pressed. */
export function panning(context: PointerContext, from: PointerInput): PointerState {
  const before = context.view();
  let isDrag = false;
  return {
    name: 'panning',
    cursor: 'grabbing',
    move(input) {
      isDrag ||= hasMoved(from, input);
      if (!isDrag) return undefined;
      const { screen } = input;
      context.setView(panBy({ ...context.view(), x: before.x, y: before.y }, screen.x - from.screen.x, screen.y - from.screen.y));
      return undefined;
    },
    up() {
      if (from.button === 2 && !isDrag) context.openMenu(from.place, from.screen);
      return undefined;
    },
    cancel: () => context.setView({ ...context.view(), x: before.x, y: before.y }),
  };
}
