import type { Destination } from '../../core/commands/index.ts';
import type { Editor } from '../../core/context/index.ts';
import { nameOf } from '../../core/document/index.ts';
import { objectRows } from './object-rows.ts';

/** The objects of the open level. */
export function objectDestinations({ open, commands }: Editor): readonly Destination[] {
  const level = open.getState();
  if (level === null) return [];
  return objectRows(level.document.file(), new Set()).flatMap(({ found, title, key }): Destination[] => {
    if (found === null) return [];
    const { x, y } = found.object;
    return [
      {
        key: `object ${key}`,
        group: 'Object',
        title,
        detail: `${title === nameOf(found) ? '' : `${nameOf(found).toLowerCase()}, `}${found.list === null ? '' : `${key}, `}at ${Math.round(x)}, ${Math.round(y)}`,
        go: () => {
          level.selection.select([key]);
          commands.run('view.fit-selection');
        },
      },
    ];
  });
}
