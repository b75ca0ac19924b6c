import type { StoreApi } from 'zustand/vanilla';
import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import type { Command } from '../commands/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import {
  alignObjects,
  type ChangeResult,
  copyObjects,
  deleteObjects,
  distributeObjects,
  duplicateObjects,
  type Edge,
  middleOf,
  moveObjects,
  objectsOf,
  pasteObjects,
  type Recipe,
  readClipping,
} from '../document/index.ts';
import type { Tool } from '../session/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { arrowsWith, type Crosshair, crosshairCommands, stepOf } from './crosshair/index.ts';
import type { PointerListening } from './pointer/index.ts';
import { toScreen, type View, zoomAt } from './view.ts';

interface CanvasParts {
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly canvas: StoreApi<CanvasState>;
  readonly setView: (view: View) => void;
  readonly bringIntoView: (keys?: readonly string[]) => void;
  readonly pointer: PointerListening;
  readonly crosshair: Crosshair;
}

const TOOL_KEYS: readonly (readonly [tool: Tool, key: string | null, title: string])[] = [
  ['select', 'v', 'Select and move'],
  ['hand', 'g', 'Move the view'],
  ...PLACEABLES.map((tool): [Tool, string | null, string] => {
    const { letter, many } = appearanceOf(tool);
    return [tool, letter, `Add ${many}`];
  }),
];

const ALIGNMENTS: readonly (readonly [edge: Edge, title: string])[] = [
  ['left', 'Align left edges'],
  ['centre', 'Align centres on an upright line'],
  ['right', 'Align right edges'],
  ['top', 'Align top edges'],
  ['middle', 'Align centres on a level line'],
  ['bottom', 'Align bottom edges'],
];

/** How far copies are laid beside what they are copies of, px. */
const BESIDE = 32;

/** What can be done on the canvas without the pointer. */
export function canvasCommands({
  editor,
  level,
  canvas,
  setView,
  bringIntoView,
  pointer,
  crosshair,
}: CanvasParts): readonly Command[] {
  const { session, settings, notices } = editor;
  const { document, selection } = level;
  const needsSelected = (least: 1 | 2 | 3) => () =>
    selection.keys().length >= least ? null : `select ${['an object', 'two objects', 'three objects'][least - 1]} first`;
  const reported = (result: ChangeResult): ChangeResult => {
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
    return result;
  };
  const change = (label: string, recipe: Recipe, gesture?: string) =>
    reported(document.change(label, recipe, gesture === undefined ? {} : { gesture }));
  const added = (result: ChangeResult) => {
    if (result.ok && result.added.length > 0) selection.select(result.added);
  };

  const nudge = (id: string, how: string, keys: readonly string[], size: () => number): Command => ({
    id: `object.${id}`,
    title: `Nudge what is selected by ${how}, while no crosshair is shown`,
    group: 'Object',
    keys,
    needs: needsSelected(1),
    hidden: true,
    run(press) {
      const { x, y } = stepOf(press);
      change('Nudge', moveObjects(selection.keys(), x * size(), y * size()), `nudge ${selection.keys().join()}`);
    },
  });
  const zoomBy = (factor: number) => {
    const { view, crosshair: place } = canvas.getState();
    setView(zoomAt(view, place === null ? { x: view.width / 2, y: view.height / 2 } : toScreen(view, place), factor));
  };
  const copy = async (): Promise<boolean> => {
    const text = copyObjects(document.file(), selection.keys());
    if (text === null) {
      notices.show('info', 'A level has one astronaut and one black hole: they can not be copied.', { topic: 'clipboard' });
      return false;
    }
    try {
      await navigator.clipboard.writeText(text);
      return true;
    } catch {
      notices.show('warning', 'The browser does not let this page write to the clipboard.', { topic: 'clipboard' });
      return false;
    }
  };
  const paste = async () => {
    let text: string;
    try {
      text = await navigator.clipboard.readText();
    } catch {
      notices.show('warning', 'The browser does not let this page read the clipboard.', { topic: 'clipboard' });
      return;
    }
    const reading = readClipping(text);
    if (!reading.ok) {
      notices.show('warning', `${reading.refusal.message}. ${reading.refusal.hint}`, { topic: 'clipboard' });
      return;
    }
    const { view } = canvas.getState();
    const middle = middleOf(reading.clipping);
    // where it was when that is on the screen, else into the middle of what is seen
    const seen =
      Math.abs(middle.x - view.x) * view.zoom < view.width / 2 && Math.abs(middle.y - view.y) * view.zoom < view.height / 2;
    const move = seen ? { x: BESIDE, y: BESIDE } : { x: Math.round(view.x - middle.x), y: Math.round(view.y - middle.y) };
    added(change(`Paste ${reading.count}`, pasteObjects(reading.clipping, move.x, move.y)));
  };
  const remove = (label: string) => {
    if (level.selection.store.getState().holds.length > 0) return;
    const fixed = selection.keys().filter((key) => objectsOf(document.file()).get(key)?.list === null);
    if (fixed.length === selection.keys().length) {
      notices.show('info', 'Every level has one astronaut and one black hole: they can be moved, not deleted.', {
        topic: 'refused',
      });
      return;
    }
    change(label, deleteObjects(selection.keys()));
  };

  return [
    ...TOOL_KEYS.map(
      ([tool, key, title]): Command => ({
        id: `tool.${tool}`,
        title,
        group: 'Edit',
        ...(key === null ? {} : { keys: [key] }),
        run: () => {
          session.setState({ tool });
          crosshair.show(title);
        },
      }),
    ),
    {
      id: 'edit.escape',
      title: 'Take back the gesture, put crosshair and tool away, select nothing',
      group: 'Edit',
      keys: ['Escape'],
      hidden: true,
      run: () => {
        if (pointer.cancel()) return;
        const isAway = session.getState().tool === 'select';
        session.setState({ tool: 'select' });
        if (!crosshair.hide() && isAway) selection.clear();
      },
    },
    { id: 'edit.select-all', title: 'Select all', group: 'Edit', keys: ['$mod+a'], run: () => selection.selectAll() },
    {
      id: 'edit.delete',
      title: 'Delete',
      group: 'Edit',
      keys: ['Delete', 'Backspace'],
      needs: needsSelected(1),
      run: () => remove('Delete'),
    },
    {
      id: 'edit.duplicate',
      title: 'Duplicate',
      group: 'Edit',
      keys: ['$mod+d'],
      needs: needsSelected(1),
      run: () => added(change('Duplicate', duplicateObjects(selection.keys(), BESIDE, BESIDE))),
    },
    { id: 'edit.copy', title: 'Copy', group: 'Edit', keys: ['$mod+c'], needs: needsSelected(1), run: () => void copy() },
    {
      id: 'edit.cut',
      title: 'Cut',
      group: 'Edit',
      keys: ['$mod+x'],
      needs: needsSelected(1),
      run: () => void copy().then((copied) => copied && remove('Cut')),
    },
    { id: 'edit.paste', title: 'Paste', group: 'Edit', keys: ['$mod+v'], run: () => void paste() },
    ...crosshairCommands(crosshair, () => selection.keys().length > 0),
    nudge('nudge', '1 px', arrowsWith(''), () => 1),
    nudge('nudge-far', 'the grid', arrowsWith('Shift+'), () => settings.getState().grid),
    ...ALIGNMENTS.map(
      ([edge, title]): Command => ({
        id: `object.align-${edge}`,
        title,
        group: 'Object',
        needs: needsSelected(2),
        run: () => change(title, alignObjects(document.file(), selection.keys(), edge)),
      }),
    ),
    ...(['x', 'y'] as const).map(
      (axis): Command => ({
        id: `object.distribute-${axis}`,
        title: axis === 'x' ? 'Distribute evenly across' : 'Distribute evenly downwards',
        group: 'Object',
        needs: needsSelected(3),
        run: () => change('Distribute', distributeObjects(document.file(), selection.keys(), axis)),
      }),
    ),
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
      title: 'Show all of the level',
      group: 'View',
      keys: ['Shift+1', 'f'],
      mode: 'both',
      run: () => bringIntoView(),
    },
    {
      id: 'view.fit-selection',
      title: 'Show what is selected',
      group: 'View',
      keys: ['Shift+2'],
      needs: needsSelected(1),
      run: () => bringIntoView(selection.keys()),
    },
  ];
}
