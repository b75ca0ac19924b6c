import { keyLabel } from '../../core/commands/index.ts';
import { type Editor, IS_MAC, type OpenLevel } from '../../core/context/index.ts';
import { reorderObject } from '../../core/document/index.ts';
import type { OrderActions } from '../../core/order/index.ts';
import type { MenuEntry } from '../../core/tree/index.ts';
import type { ObjectRow } from './object-rows.ts';

interface MenuParts {
  readonly editor: Editor;
  readonly level: OpenLevel;
  readonly rows: readonly ObjectRow[];
  readonly order: OrderActions;
  readonly onShow: (row: ObjectRow) => void;
  readonly onToggle: (row: ObjectRow) => void;
  readonly onRename: (row: ObjectRow) => void;
}

const key = (binding: string): string => keyLabel(binding, IS_MAC);

/** Lock, hide and the like, of an object or a group. */
function orderEntries(row: ObjectRow, { order, onRename }: MenuParts): readonly MenuEntry[] {
  const { isLocked, isHidden } = row.marks;
  const entries: MenuEntry[] = [
    { title: 'Rename…', keys: 'F2', run: () => onRename(row) },
    { title: isLocked ? 'Unlock' : 'Lock', keys: key('$mod+Shift+l'), run: () => order.lock(row.keys, !isLocked) },
  ];
  if (row.kind !== 'astronaut')
    entries.push({ title: isHidden ? 'Show' : 'Hide', keys: key('$mod+Shift+h'), run: () => order.hide(row.keys, !isHidden) });
  return entries;
}

/** The context menu of a row of the outline. */
export function outlineMenu(row: ObjectRow, parts: MenuParts): readonly MenuEntry[] {
  const { editor, level, rows, order, onShow, onToggle } = parts;
  const { selection, document } = level;
  const fold: MenuEntry = { title: row.expanded === true ? 'Collapse' : 'Expand', run: () => onToggle(row) };
  if (row.group !== null) {
    return [
      { title: 'Select all of the group', run: () => selection.select(row.keys) },
      fold,
      null,
      ...orderEntries(row, parts),
      { title: 'Ungroup', keys: key('$mod+Shift+g'), run: () => order.ungroup(row.keys) },
    ];
  }
  if (row.found === null) {
    return [{ title: `Select all ${row.title.toLowerCase()}`, run: () => selection.select(row.keys) }, fold];
  }
  const { list, place, siblings } = row;
  const withIt = (id: string) => () => {
    if (!selection.keys().includes(row.key)) selection.select([row.key]);
    editor.commands.run(id);
  };
  const move = (to: number) => () => void document.change(`Reorder ${row.title}`, reorderObject(row.key, to));
  const fixed = list === null;
  const isLast = place === siblings - 1;
  const several = selection.keys().includes(row.key) && selection.keys().length > 1;
  return [
    { title: 'Bring into view', keys: 'Enter', run: () => onShow(row) },
    {
      title: 'Select all of this kind',
      run: () => selection.select(rows.filter(({ kind, found }) => kind === row.kind && found !== null).flatMap((r) => r.keys)),
    },
    null,
    ...orderEntries(row, parts),
    { title: 'Group the selection', keys: key('$mod+g'), disabled: !several, run: () => order.group(selection.keys()) },
    null,
    { title: 'Duplicate', keys: key('$mod+d'), disabled: fixed, run: withIt('edit.duplicate') },
    { title: 'Copy', keys: key('$mod+c'), disabled: fixed, run: withIt('edit.copy') },
    { title: 'Delete', keys: 'Del', disabled: fixed || row.marks.isLocked, run: withIt('edit.delete') },
    null,
    { title: 'Move to top', disabled: fixed || place === 0, run: move(0) },
    { title: 'Move up', keys: 'Alt ↑', disabled: fixed || place === 0, run: move(place - 1) },
    { title: 'Move down', keys: 'Alt ↓', disabled: fixed || isLast, run: move(place + 1) },
  ];
}
