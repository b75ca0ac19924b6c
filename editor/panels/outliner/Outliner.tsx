import { ChevronRight, TriangleAlert } from 'lucide-react';
import { memo, useDeferredValue, useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { isVariant, type LevelFile, type ObjectKind } from '../../../schema/index.ts';
import { signOf } from '../../canvas/index.ts';
import { useEditor, useLevel, useSelectedKeys, useWhenIdle } from '../../context/index.ts';
import { type DocumentState, type ObjectKey, reorderObject } from '../../document/index.ts';
import { leavesBetween, type MenuEntry, type Modifiers, MoreButton, Tree } from '../tree/index.ts';
import { type ObjectRow, objectRows } from './object-rows.ts';
import './outliner.css';
import { useProblems } from './use-problems.ts';

/** px */
const rowHeight = () => 26;

const fileOf = ({ file }: DocumentState): LevelFile => file;

/** All objects of the level by kind; the selection is shared with the canvas. */
export function Outliner() {
  // The canvas has priority during a drag.
  const file = useWhenIdle(useLevel().document.store, fileOf);
  const keys = useDeferredValue(useSelectedKeys());
  return <Outline file={file} keys={keys} />;
}

const Outline = memo(function Outline({ file, keys }: { readonly file: LevelFile; readonly keys: readonly ObjectKey[] }) {
  const { commands } = useEditor();
  const { document, selection, hovered } = useLevel();
  const selected = useMemo(() => new Set(keys), [keys]);
  const problems = useProblems();
  const pointedAt = useStore(hovered);
  const [folded, setFolded] = useState<ReadonlySet<ObjectKind>>(new Set());
  const [active, setActive] = useState<string | null>(null);
  /** The start of the range that Shift selects. */
  const anchor = useRef<string | null>(null);
  const rows = useMemo(() => objectRows(file, folded), [file, folded]);

  const last = keys[keys.length - 1] ?? null;
  useEffect(() => {
    if (last === null) return;
    setActive((now) => (now !== null && selection.keys().includes(now) ? now : last));
    anchor.current ??= last;
  }, [last, selection]);

  const toggle = ({ kind }: ObjectRow) =>
    setFolded((now) => (now.has(kind) ? new Set([...now].filter((other) => other !== kind)) : new Set([...now, kind])));
  const pick = ({ key, expanded }: ObjectRow, { shift, mod }: Modifiers) => {
    if (expanded !== null) return;
    if (shift && anchor.current !== null) {
      selection.select(leavesBetween(rows, anchor.current, key));
      return;
    }
    anchor.current = key;
    if (mod) selection.toggle(key);
    else selection.select([key]);
  };
  const show = ({ keys }: ObjectRow) => {
    selection.select(keys);
    commands.run('view.fit-selection');
  };
  const move = ({ key, title }: ObjectRow, place: number) => document.change(`Reorder ${title}`, reorderObject(key, place));
  const menu = (row: ObjectRow): readonly MenuEntry[] => {
    if (row.found === null) {
      return [
        { title: `Select all ${row.title.toLowerCase()}`, run: () => selection.select(row.keys) },
        { title: row.expanded === true ? 'Collapse' : 'Expand', run: () => toggle(row) },
      ];
    }
    const { list, place, siblings } = row;
    const withIt = (id: string) => () => {
      if (!selection.keys().includes(row.key)) selection.select([row.key]);
      commands.run(id);
    };
    const fixed = list === null;
    return [
      { title: 'Bring into view', keys: 'Enter', run: () => show(row) },
      {
        title: `Select all of this kind`,
        run: () => selection.select(rows.filter(({ kind }) => kind === row.kind).flatMap((r) => r.keys)),
      },
      null,
      { title: 'Duplicate', disabled: fixed, run: withIt('edit.duplicate') },
      { title: 'Copy', disabled: fixed, run: withIt('edit.copy') },
      { title: 'Delete', keys: 'Del', disabled: fixed, run: withIt('edit.delete') },
      null,
      { title: 'Move to top', disabled: fixed || place === 0, run: () => move(row, 0) },
      { title: 'Move up', keys: 'Alt ↑', disabled: fixed || place === 0, run: () => move(row, place - 1) },
      { title: 'Move down', keys: 'Alt ↓', disabled: fixed || place === siblings - 1, run: () => move(row, place + 1) },
    ];
  };

  return (
    <section className="panel outliner" aria-label="Objects">
      <div className="panel__head">
        <h2 className="panel__title">Objects</h2>
        <span className="outliner__count numbers">
          {rows.reduce((sum, row) => sum + (row.found === null ? row.keys.length : 0), 2)}
        </span>
      </div>
      <Tree
        label="Objects of the level"
        rows={rows}
        rowHeight={rowHeight}
        multiple
        follows
        selected={selected}
        hovered={pointedAt}
        active={active}
        onActive={setActive}
        onPick={pick}
        onOpen={show}
        onToggle={toggle}
        onMove={move}
        onHover={(row) => hovered.setState(row === null || row.found === null ? null : row.key, true)}
        menu={menu}
        render={(row) => <ObjectLine row={row} problems={problems.get(row.key)} />}
      />
    </section>
  );
});

function ObjectLine({ row, problems }: { row: ObjectRow; problems: readonly string[] | undefined }) {
  const { title, kind, found, expanded, keys } = row;
  if (found === null) {
    return (
      <>
        <ChevronRight size={13} className={`outliner__fold${expanded === true ? ' outliner__fold--open' : ''}`} aria-hidden />
        <span className="outliner__kind">{title}</span>
        <span className="outliner__count numbers">{keys.length}</span>
      </>
    );
  }
  const { Icon, tone } = signOf(kind, isVariant(kind, found.object));
  return (
    <>
      <Icon size={14} className={`outliner__icon outliner__icon--${tone}`} />
      <span className="outliner__name">{title}</span>
      {found.list !== null && <span className="outliner__id">{found.key}</span>}
      {problems !== undefined && (
        <span className="outliner__problem" role="img" aria-label={problems.join('; ')} title={problems.join('\n')}>
          <TriangleAlert size={13} />
        </span>
      )}
      <span className="outliner__place numbers">
        <span className="unseen">at </span>
        {Math.round(found.object.x)}, {Math.round(found.object.y)}
      </span>
      <MoreButton />
    </>
  );
}
