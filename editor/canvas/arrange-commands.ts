import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { alignObjects, distributeObjects, type Edge, moveObjects } from '../core/document/index.ts';
import { arrowsWith, stepOf } from './crosshair-commands.ts';
import { type ObjectChanges, transformActions } from './selection-changes.ts';

const ALIGNMENTS: readonly (readonly [edge: Edge, title: string])[] = [
  ['left', 'Align left edges'],
  ['centre', 'Align horizontal centres'],
  ['right', 'Align right edges'],
  ['top', 'Align top edges'],
  ['middle', 'Align vertical centres'],
  ['bottom', 'Align bottom edges'],
];

/** Nudges, aligns and distributes the selection. */
export function arrangeCommands(
  { settings }: Editor,
  { document, selection }: OpenLevel,
  { needsSelected, free, change }: ObjectChanges,
): readonly Command[] {
  const nudge = (id: string, how: string, keys: readonly string[], size: () => number): Command => ({
    id: `object.${id}`,
    title: `Nudge the selection by ${how} while the crosshair is hidden`,
    group: 'Object',
    keys,
    needs: needsSelected(1),
    hidden: true,
    run(press) {
      const { x, y } = stepOf(press);
      change('Nudge', moveObjects(free(), x * size(), y * size()), `nudge ${selection.keys().join()}`);
    },
  });
  return [
    nudge('nudge', '1 px', arrowsWith(''), () => 1),
    nudge('nudge-far', 'the grid', arrowsWith('Shift+'), () => settings.getState().grid),
    ...ALIGNMENTS.map(
      ([edge, title]): Command => ({
        id: `object.align-${edge}`,
        title,
        group: 'Object',
        needs: needsSelected(2),
        run: () => change(title, alignObjects(document.file(), free(), edge)),
      }),
    ),
    ...(['x', 'y'] as const).map(
      (axis): Command => ({
        id: `object.distribute-${axis}`,
        title: axis === 'x' ? 'Distribute horizontally' : 'Distribute vertically',
        group: 'Object',
        needs: needsSelected(3),
        run: () => change('Distribute', distributeObjects(document.file(), free(), axis)),
      }),
    ),
  ];
}

const TURNS: readonly (readonly [id: string, title: string, keys: readonly string[], degrees: number])[] = [
  ['turn-left', 'Turn the selection by 1° to the left', ['Alt+Comma'], -1],
  ['turn-right', 'Turn the selection by 1° to the right', ['Alt+Period'], 1],
  ['turn-left-far', 'Turn the selection by 15° to the left', ['Shift+Alt+Comma'], -15],
  ['turn-right-far', 'Turn the selection by 15° to the right', ['Shift+Alt+Period'], 15],
];

/** Turns and mirrors the selection about the middle of its box. */
export function transformCommands(level: OpenLevel, changes: ObjectChanges): readonly Command[] {
  const { selection } = level;
  const actions = transformActions(level, changes);
  const needs = changes.needsSelected(1);
  return [
    ...TURNS.map(
      ([id, title, keys, degrees]): Command => ({
        id: `object.${id}`,
        title,
        group: 'Object',
        keys,
        needs,
        run: () => actions.turn(degrees, `turn ${selection.keys().join()}`),
      }),
    ),
    {
      id: 'object.mirror-x',
      title: 'Mirror the selection from left to right',
      group: 'Object',
      keys: ['Shift+h'],
      needs,
      run: () => actions.mirror('x'),
    },
    {
      id: 'object.mirror-y',
      title: 'Mirror the selection from top to bottom',
      group: 'Object',
      keys: ['Shift+v'],
      needs,
      run: () => actions.mirror('y'),
    },
  ];
}
