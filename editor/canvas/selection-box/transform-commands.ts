import type { Command } from '../../core/commands/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import type { ObjectChanges } from '../object-changes.ts';
import { transformActions } from './transform-actions.ts';

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
