import type { StoreApi } from 'zustand/vanilla';
import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { objectsOf } from '../core/document/index.ts';
import { orderCommands } from '../core/order/index.ts';
import { chooseTool, type Tool } from '../core/session/index.ts';
import { arrangeCommands, transformCommands } from './arrange-commands.ts';
import type { CanvasState } from './canvas-state.ts';
import { clipboardCommands } from './clipboard-commands.ts';
import type { Crosshair } from './crosshair.ts';
import { crosshairCommands } from './crosshair-commands.ts';
import { clickAgain, hitsOf, type PointerContext, type PointerListening } from './pointer/index.ts';
import type { ObjectChanges } from './selection-changes.ts';
import { isInView, type Point, toScreen, type View, zoomAt } from './view.ts';

interface CanvasParts {
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly canvas: StoreApi<CanvasState>;
  readonly context: PointerContext;
  readonly changes: ObjectChanges;
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

/** The commands of the canvas. */
export function canvasCommands(parts: CanvasParts): readonly Command[] {
  const { editor, level, canvas, context, changes, pointer, crosshair } = parts;
  const { session } = editor;
  const { selection } = level;
  /** The place that keys mean: the crosshair, else the selected object, else the middle of the view. */
  const placeMeant = (): Point => {
    const view = context.view();
    if (crosshair.isShown()) return crosshair.place();
    const [key] = selection.keys();
    const object = key === undefined ? undefined : objectsOf(level.document.file()).get(key)?.object;
    return object !== undefined && isInView(view, object) ? object : { x: view.x, y: view.y };
  };
  /** The crosshair, the place of the last click, or the selected object. */
  const placeOfClick = (): Point => {
    const last = context.clicks.getState();
    return crosshair.isShown() || last === null ? crosshair.place() : last.place;
  };
  return [
    ...TOOL_KEYS.map(
      ([tool, key, title]): Command => ({
        id: `tool.${tool}`,
        title,
        group: 'Edit',
        ...(key === null ? {} : { keys: [key] }),
        run: () => {
          chooseTool(session, tool);
          crosshair.show(title);
        },
      }),
    ),
    {
      id: 'tool.lock',
      title: 'Keep the tool after placing an object, or not',
      group: 'Edit',
      keys: ['q'],
      run: () => session.setState({ isToolLocked: !session.getState().isToolLocked }),
    },
    {
      id: 'edit.escape',
      title: 'Cancel the gesture, crosshair and tool with its lock; clear the selection',
      group: 'Edit',
      keys: ['Escape'],
      hidden: true,
      run: () => {
        canvas.setState({ message: null });
        if (pointer.cancel()) return;
        const isAway = session.getState().tool === 'select';
        chooseTool(session, 'select');
        if (!crosshair.hide() && isAway) selection.clear();
      },
    },
    { id: 'edit.select-all', title: 'Select all', group: 'Edit', keys: ['$mod+a'], run: () => selection.selectAll() },
    ...orderCommands(editor, level),
    {
      id: 'edit.next-here',
      title: 'Select the next object at the same place',
      group: 'Edit',
      keys: ['j'],
      needs: () => (hitsOf(context, { place: placeOfClick(), by: 'keys' }).length > 0 ? null : 'click on an object first'),
      run: () => clickAgain(context, placeOfClick()),
    },
    {
      id: 'edit.menu',
      title: 'Menu of what is at the crosshair or selected',
      group: 'Edit',
      keys: ['Shift+F10', 'ContextMenu'],
      needs: () => (crosshair.hasFocus() ? null : 'go to the canvas first'),
      run() {
        const at = placeMeant();
        context.openMenu(at, toScreen(context.view(), at));
      },
    },
    ...clipboardCommands(editor, level, canvas, changes),
    ...crosshairCommands(crosshair, () => selection.keys().length > 0),
    ...arrangeCommands(editor, level, changes),
    ...transformCommands(level, changes),
    {
      id: 'note.add',
      title: 'Add a note at the crosshair or the selected object',
      group: 'Edit',
      keys: ['Shift+t'],
      run() {
        const { x, y } = placeMeant();
        session.setState({ openNote: { x: Math.round(x), y: Math.round(y) } });
      },
    },
    {
      id: 'object.repeat',
      title: 'Repeat the selection along a line or around a centre',
      group: 'Object',
      keys: ['$mod+Shift+d'],
      needs: changes.needsSelected(1),
      run: () => changes.free().length > 0 && canvas.setState({ isRepeating: true }),
    },
    ...viewCommands(parts),
  ];
}

/** Zooms, and brings objects into view. */
function viewCommands({ level, canvas, changes, setView, bringIntoView }: CanvasParts): readonly Command[] {
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
      needs: changes.needsSelected(1),
      run: () => bringIntoView(level.selection.keys()),
    },
  ];
}
