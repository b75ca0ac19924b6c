import type { StoreApi } from 'zustand/vanilla';
import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { orderCommands } from '../core/order/index.ts';
import { chooseTool, type Tool } from '../core/session/index.ts';
import { arrangeCommands } from './arrange-commands.ts';
import type { CanvasState } from './canvas-state.ts';
import { clipboardCommands } from './clipboard-commands.ts';
import { type Crosshair, crosshairCommands } from './crosshair/index.ts';
import { menuCommands, placeMeant } from './menu/index.ts';
import type { ObjectChanges } from './object-changes.ts';
import { overlapCommands } from './overlap-commands.ts';
import type { PointerContext, PointerListening } from './pointer/index.ts';
import { transformCommands } from './selection-box/index.ts';
import type { View } from './view.ts';
import { viewCommands } from './view-commands.ts';

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
  const { editor, level, canvas, context, changes, pointer, crosshair, setView, bringIntoView } = parts;
  const { session } = editor;
  const { selection } = level;
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
        canvas.setState({ told: null });
        if (pointer.cancel()) return;
        const isAway = session.getState().tool === 'select';
        chooseTool(session, 'select');
        if (!crosshair.hide() && isAway) selection.clear();
      },
    },
    { id: 'edit.select-all', title: 'Select all', group: 'Edit', keys: ['$mod+a'], run: () => selection.selectAll() },
    ...orderCommands(editor, level),
    ...overlapCommands(context, crosshair),
    ...menuCommands(context, crosshair),
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
        const { x, y } = placeMeant(context, crosshair);
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
    ...viewCommands({ selection, canvas, setView, bringIntoView }, changes),
  ];
}
