import type { Command } from '../../commands/index.ts';
import type { OpenLevel } from '../../context/index.ts';
import { type LinearMap, mapObjects, mapProblem, mirrorAlong, turnBy } from '../../document/index.ts';
import { extentOf } from '../extent.ts';
import type { ObjectChanges } from '../object-changes.ts';
import { centreOf } from './box.ts';

const TURNS: readonly (readonly [id: string, title: string, keys: readonly string[], degrees: number])[] = [
  ['turn-left', 'Turn the selection by 1° to the left', ['Alt+Comma'], -1],
  ['turn-right', 'Turn the selection by 1° to the right', ['Alt+Period'], 1],
  ['turn-left-far', 'Turn the selection by 15° to the left', ['Shift+Alt+Comma'], -15],
  ['turn-right-far', 'Turn the selection by 15° to the right', ['Shift+Alt+Period'], 15],
];

/** Turns and mirrors the selection about the middle of its box. */
export function transformCommands(
  { document, selection, proof }: OpenLevel,
  { needsSelected, free, change, refuse }: ObjectChanges,
): readonly Command[] {
  const mapBy = (label: string, map: LinearMap, gesture?: string) => {
    const keys = free();
    const file = document.file();
    const box = extentOf(file, proof.proof().scene.box, keys);
    if (box === null) return;
    const problem = mapProblem(file, keys, map);
    if (problem !== null) refuse(problem);
    else change(label, mapObjects(keys, centreOf(box), map), gesture);
  };
  return [
    ...TURNS.map(
      ([id, title, keys, degrees]): Command => ({
        id: `object.${id}`,
        title,
        group: 'Object',
        keys,
        needs: needsSelected(1),
        run: () => mapBy('Turn', turnBy(degrees), `turn ${selection.keys().join()}`),
      }),
    ),
    {
      id: 'object.mirror-x',
      title: 'Mirror the selection from left to right',
      group: 'Object',
      keys: ['Shift+h'],
      needs: needsSelected(1),
      run: () => mapBy('Mirror', mirrorAlong('x')),
    },
    {
      id: 'object.mirror-y',
      title: 'Mirror the selection from top to bottom',
      group: 'Object',
      keys: ['Shift+v'],
      needs: needsSelected(1),
      run: () => mapBy('Mirror', mirrorAlong('y')),
    },
  ];
}
