import { ChevronRight, Eye, EyeOff, Group, Lock, LockOpen, TriangleAlert } from 'lucide-react';
import { memo, type ReactNode } from 'react';
import { isVariant } from '../../../schema/index.ts';
import { signOf } from '../../canvas/index.ts';
import { keyLabel } from '../../core/commands/index.ts';
import { type Editor, IS_MAC, type OpenLevel } from '../../core/context/index.ts';
import { LONGEST_NAME, nameOf, reorderObject } from '../../core/document/index.ts';
import type { OrderActions } from '../../core/order/index.ts';
import { InlineName, type MenuEntry, MoreButton } from '../../core/tree/index.ts';
import { isSameRow, type ObjectRow } from './object-rows.ts';

/** What can be done in a row. */
export interface LineActions {
  onLock(row: ObjectRow): void;
  onHide(row: ObjectRow): void;
  onRename(row: ObjectRow, name: string): void;
  /** Why a row can't have a name, and what to do; null: it can. */
  problemOf(row: ObjectRow, name: string): string | null;
  onRenamed(): void;
}

interface ObjectLineProps {
  readonly row: ObjectRow;
  /** Stable between renders as long as they are the same. */
  readonly problems: readonly string[] | undefined;
  /** Whether its name is being edited. */
  readonly isRenaming: boolean;
  /** Stable between renders. */
  readonly actions: LineActions;
}

/** A toggle at the end of a row. The keyboard has the menu of the row and the commands instead. */
function Toggle({ title, isOn, onClick, children }: { title: string; isOn: boolean; onClick: () => void; children: ReactNode }) {
  return (
    <button
      type="button"
      className={isOn ? 'tree__more outliner__toggle outliner__toggle--on' : 'tree__more outliner__toggle'}
      tabIndex={-1}
      aria-hidden
      title={title}
      // the focus stays in the tree, which handles the keys
      onMouseDown={(event) => event.preventDefault()}
      onDoubleClick={(event) => event.stopPropagation()}
      onClick={(event) => {
        event.stopPropagation();
        onClick();
      }}
    >
      {children}
    </button>
  );
}

function Signs({ row, actions }: Pick<ObjectLineProps, 'row' | 'actions'>) {
  const { isLocked, isHidden } = row.marks;
  return (
    <>
      {(isLocked || isHidden) && (
        <span className="unseen">{[isLocked && 'locked', isHidden && 'hidden'].filter(Boolean).join(', ')}</span>
      )}
      <Toggle title={isHidden ? 'Show' : 'Hide'} isOn={isHidden} onClick={() => actions.onHide(row)}>
        {isHidden ? <EyeOff size={13} /> : <Eye size={13} />}
      </Toggle>
      <Toggle title={isLocked ? 'Unlock' : 'Lock'} isOn={isLocked} onClick={() => actions.onLock(row)}>
        {isLocked ? <Lock size={13} /> : <LockOpen size={13} />}
      </Toggle>
    </>
  );
}

const isSameLine = (a: ObjectLineProps, b: ObjectLineProps): boolean =>
  isSameRow(a.row, b.row) && a.problems === b.problems && a.isRenaming === b.isRenaming && a.actions === b.actions;

/**
 * A row of the outline: a folder, or an object with its name, place and signs. Memoized, as a drag changes one of many rows at each
 * step.
 */
export const ObjectLine = memo(function ObjectLine({ row, problems, isRenaming, actions }: ObjectLineProps) {
  const { title, kind, found, expanded, keys, group } = row;
  const name = (
    <InlineName
      label={group === null ? `Name of ${title}` : `Name of the group ${title}`}
      value={title}
      longest={LONGEST_NAME}
      problemOf={(wanted) => actions.problemOf(row, wanted)}
      onDone={(wanted) => actions.onRename(row, wanted)}
      onEnd={actions.onRenamed}
    />
  );
  if (found === null || kind === null) {
    return (
      <>
        <ChevronRight size={13} className={`outliner__fold${expanded === true ? ' outliner__fold--open' : ''}`} aria-hidden />
        {group !== null && <Group size={14} className="outliner__icon" aria-hidden />}
        {isRenaming ? name : <span className={group === null ? 'outliner__kind' : 'outliner__group'}>{title}</span>}
        {group !== null && <span className="unseen">group</span>}
        {group !== null && <Signs row={row} actions={actions} />}
        <span className="outliner__count numbers">{keys.length}</span>
        {group !== null && <MoreButton />}
      </>
    );
  }
  const { Icon, tone } = signOf(kind, isVariant(kind, found.object));
  const usual = nameOf(found);
  return (
    <>
      <Icon size={14} className={`outliner__icon outliner__icon--${tone}`} />
      {isRenaming ? name : <span className="outliner__name">{title}</span>}
      {!isRenaming && title !== usual && <span className="outliner__id outliner__usual">{usual}</span>}
      {!isRenaming && title === usual && found.list !== null && <span className="outliner__id">{found.key}</span>}
      {problems !== undefined && (
        <span className="outliner__problem" role="img" aria-label={problems.join('; ')} title={problems.join('\n')}>
          <TriangleAlert size={13} />
        </span>
      )}
      <span className="outliner__place numbers">
        <span className="unseen">at </span>
        {Math.round(found.object.x)}, {Math.round(found.object.y)}
      </span>
      <Signs row={row} actions={actions} />
      <MoreButton />
    </>
  );
}, isSameLine);

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
