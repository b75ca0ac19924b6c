import { useEffect } from 'react';
import type { StoreApi } from 'zustand';
import { useEditor, useLevel } from '../context/index.ts';
import { watchLeeway } from '../leeway/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { toLevel } from './view.ts';

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
