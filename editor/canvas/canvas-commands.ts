import type { StoreApi } from 'zustand/vanilla';
import { appearanceOf, PLACEABLES } from '../../schema/index.ts';
import type { Command } from '../commands/index.ts';
import type { Editor, OpenLevel } from '../context/index.ts';
import type { Tool } from '../session/index.ts';
import { arrangeCommands } from './arrange-commands.ts';
import type { CanvasState } from './canvas-state.ts';
import { clipboardCommands } from './clipboard-commands.ts';
import { type Crosshair, crosshairCommands } from './crosshair/index.ts';
import { objectChanges } from './object-changes.ts';
import type { PointerListening } from './pointer/index.ts';
import type { View } from './view.ts';
import { viewCommands } from './view-commands.ts';

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

/** The commands of the canvas. */
export function canvasCommands(parts: CanvasParts): readonly Command[] {
  const { editor, level, canvas, pointer, crosshair, setView, bringIntoView } = parts;
  const { session } = editor;
  const { selection } = level;
  const changes = objectChanges(editor, level);
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
      title: 'Cancel the gesture, crosshair and tool; clear the selection',
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
    ...clipboardCommands(editor, level, canvas, changes),
    ...crosshairCommands(crosshair, () => selection.keys().length > 0),
    ...arrangeCommands(editor, level, changes),
    ...viewCommands({ selection, canvas, setView, bringIntoView }, changes),
  ];
}
