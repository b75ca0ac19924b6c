import { type StoreApi, useStore } from 'zustand';
import type { CanvasState } from './canvas-state.ts';
import type { Point } from './view.ts';
import { toScreen, type View } from './view.ts';

/** Beside a place, towards the middle of the view. */
function beside(view: View, at: Point): string {
  const { x, y } = toScreen(view, at);
  const isLeft = x > view.width / 2;
  return `translate(${x + (isLeft ? -14 : 14)}px, ${y + 14}px) translate(${isLeft ? -100 : 0}%, 0)`;
}

/** Figures of a gesture; they change with every move, so they are not read out. */
export function Measures({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const measures = useStore(canvas, (state) => state.measures);
  const view = useStore(canvas, (state) => state.view);
  return measures.map(({ words, at }, index) => (
    // biome-ignore lint/suspicious/noArrayIndexKey: figures have no name
    <div key={index} className="canvas__told numbers" aria-hidden style={{ transform: beside(view, at) }}>
      {words}
    </div>
  ));
}

/** What was said beside a place: `2 of 3 here`. */
export function ToldLabel({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const told = useStore(canvas, (state) => state.told);
  const view = useStore(canvas, (state) => state.view);
  return (
    <div
      className={told === null ? 'canvas__told unseen' : 'canvas__told'}
      role="status"
      aria-label="At this place"
      style={told === null ? {} : { transform: beside(view, told.at) }}
    >
      {told?.words}
    </div>
  );
}
