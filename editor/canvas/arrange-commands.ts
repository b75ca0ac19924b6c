import type { Command } from '../core/commands/index.ts';
import type { Editor, OpenLevel } from '../core/context/index.ts';
import { alignObjects, distributeObjects, type Edge, moveObjects } from '../core/document/index.ts';
import { arrowsWith, stepOf } from './crosshair/index.ts';
import type { ObjectChanges } from './object-changes.ts';

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
