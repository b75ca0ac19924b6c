import { panBy } from '../view.ts';
import type { PointerContext, PointerInput, PointerState } from './state.ts';

/** Moves the view. */
export function panning(context: PointerContext, from: PointerInput): PointerState {
  const before = context.view();
  return {
    name: 'panning',
    cursor: 'grabbing',
    move({ screen }) {
      context.setView(panBy({ ...context.view(), x: before.x, y: before.y }, screen.x - from.screen.x, screen.y - from.screen.y));
      return undefined;
    },
    cancel: () => context.setView({ ...context.view(), x: before.x, y: before.y }),
  };
}
