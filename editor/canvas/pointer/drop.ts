import { appearanceOf, PLACEABLES } from '../../../schema/index.ts';
import { addObject } from '../../core/document/index.ts';
import { toLevel } from '../view.ts';
import { placeFor } from './place-object.ts';
import type { PointerContext } from './state.ts';

/** the data type of a tool that is dragged onto the canvas */
export const DRAGGED_TOOL = 'application/x-gq-tool';

/** Lets the user drag tools from the toolbar onto the canvas. @returns stops it */
export function listenToDrops(element: HTMLElement, context: PointerContext): () => void {
  const stopping = new AbortController();
  const options = { signal: stopping.signal };
  const placeOf = (event: DragEvent) => {
    const box = element.getBoundingClientRect();
    const screen = { x: event.clientX - box.left, y: event.clientY - box.top };
    const mod = event.ctrlKey || event.metaKey;
    return placeFor(context, { place: toLevel(context.view(), screen), mod });
  };
  element.addEventListener(
    'dragover',
    (event) => {
      if (event.dataTransfer?.types.includes(DRAGGED_TOOL) !== true) return;
      event.preventDefault();
      event.dataTransfer.dropEffect = 'copy';
      context.canvas.setState({ placing: placeOf(event) });
    },
    options,
  );
  element.addEventListener('dragleave', () => context.canvas.setState({ placing: null }), options);
  element.addEventListener(
    'drop',
    (event) => {
      const name = event.dataTransfer?.getData(DRAGGED_TOOL);
      const tool = PLACEABLES.find((one) => one === name);
      context.canvas.setState({ placing: null });
      if (tool === undefined) return;
      event.preventDefault();
      const { x, y } = placeOf(event);
      const result = context.document.change(`Add ${appearanceOf(tool).one}`, addObject(tool, x, y));
      if (result.ok) context.selection.select(result.added);
      else context.refused(result.refusal.message);
      element.focus({ preventScroll: true });
    },
    options,
  );
  return () => stopping.abort();
}
