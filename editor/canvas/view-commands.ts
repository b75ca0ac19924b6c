import type { StoreApi } from 'zustand/vanilla';
import type { Command } from '../core/commands/index.ts';
import type { SelectionStore } from '../core/document/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { ObjectChanges } from './object-changes.ts';
import { toScreen, type View, zoomAt } from './view.ts';

interface ViewParts {
  readonly selection: SelectionStore;
  readonly canvas: StoreApi<CanvasState>;
  readonly setView: (view: View) => void;
  readonly bringIntoView: (keys?: readonly string[]) => void;
}

/** Zooms, and brings objects into view. */
export function viewCommands(
  { selection, canvas, setView, bringIntoView }: ViewParts,
  { needsSelected }: ObjectChanges,
): readonly Command[] {
  const zoomBy = (factor: number) => {
    const { view, crosshair: place } = canvas.getState();
    setView(zoomAt(view, place === null ? { x: view.width / 2, y: view.height / 2 } : toScreen(view, place), factor));
  };
  return [
    { id: 'view.zoom-in', title: 'Zoom in', group: 'View', keys: ['Equal', '$mod+Equal'], mode: 'both', run: () => zoomBy(1.25) },
    {
      id: 'view.zoom-out',
      title: 'Zoom out',
      group: 'View',
      keys: ['Minus', '$mod+Minus'],
      mode: 'both',
      run: () => zoomBy(0.8),
    },
    {
      id: 'view.actual-size',
      title: 'Actual size',
      group: 'View',
      keys: ['$mod+0'],
      mode: 'both',
      run: () => zoomBy(1 / canvas.getState().view.zoom),
    },
    {
      id: 'view.fit',
      title: 'Fit the level in the view',
      group: 'View',
      keys: ['Shift+1', 'f'],
      mode: 'both',
      run: () => bringIntoView(),
    },
    {
      id: 'view.fit-selection',
      title: 'Bring the selection into view',
      group: 'View',
      keys: ['Shift+2'],
      needs: needsSelected(1),
      run: () => bringIntoView(selection.keys()),
    },
  ];
}
