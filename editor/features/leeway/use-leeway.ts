import { useEffect } from 'react';
import type { StoreApi } from 'zustand';
import { type CanvasState, toLevel } from '../../canvas/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { watchLeeway } from './watch-leeway.ts';

/** Samples where the selection may stand, in what the canvas shows, for as long as that is shown. */
export function useLeeway(canvas: StoreApi<CanvasState>): void {
  const { session, settings, desk } = useEditor();
  const level = useLevel();
  useEffect(() => {
    const now = () => {
      const { view } = canvas.getState();
      const from = toLevel(view, { x: 0, y: 0 });
      const to = toLevel(view, { x: view.width, y: view.height });
      return { left: from.x, top: from.y, right: to.x, bottom: to.y };
    };
    const subscribe = (call: () => void) =>
      canvas.subscribe((state, before) => {
        if (state.view !== before.view) call();
      });
    return watchLeeway({ level, session, settings, desk, seen: { now, subscribe } });
  }, [canvas, level, session, settings, desk]);
}
