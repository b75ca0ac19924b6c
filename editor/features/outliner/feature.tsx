import { ListTree, MessageSquareText } from 'lucide-react';
import { memo, useDeferredValue, useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { LevelFile } from '../../../schema/index.ts';
import { useAtRest, useInPace } from '../../core/ask/index.ts';
import { type Editor, perLevel, useEditor, useLevel, useSelectedKeys, useSession } from '../../core/context/index.ts';
import {
  type DocumentState,
  groupsIn,
  keyAt,
  nameOf,
  type ObjectKey,
  objectsOf,
  type PinnedNote,
  pinnedNotesIn,
  reorderObject,
} from '../../core/document/index.ts';
import { orderActions } from '../../core/order/index.ts';
import { leavesBetween, type Modifiers, Tree, toggledIn } from '../../core/tree/index.ts';
import type { Feature } from '../feature.ts';
import { type LineActions, ObjectLine, outlineMenu } from './ObjectLine.tsx';
import { type ObjectRow, objectRows } from './object-rows.ts';
import './outliner.css';
import type { Destination } from '../../core/commands/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

/** All objects of the level as a tree. */
export const outliner: Feature = {
  name: 'outliner',
  panel: {
    id: 'outline',
    title: 'Outline',
    icon: <ListTree size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(Outliner),
  },
  destinations: objectDestinations,
};

/** px */
const rowHeight = () => 26;

const fileOf = ({ file }: DocumentState): LevelFile => file;

/** All objects of the level by group and kind; the selection is shared with the canvas. */
function Outliner() {
  // The canvas has priority during a drag.
  const file = useInPace(useLevel().document.store, fileOf, 'idle');
  const keys = useDeferredValue(useSelectedKeys());
  return <Outline file={file} keys={keys} />;
}

const Outline = memo(function Outline({ file, keys }: { readonly file: LevelFile; readonly keys: readonly ObjectKey[] }) {
  const editor = useEditor();
  const level = useLevel();
  const { commands, session } = editor;
  const { document, selection, hovered } = level;
  const selected = useMemo(() => new Set(keys), [keys]);
  const problems = useProblems();
  const pointedAt = useStore(hovered);
  const renaming = useSession((state) => state.renaming);
  const [folded, setFolded] = useState<ReadonlySet<string>>(new Set());
  const [active, setActive] = useState<string | null>(null);
  /** The start of the range that Shift selects. */
  const anchor = useRef<string | null>(null);
  const rows = useMemo(() => objectRows(file, folded), [file, folded]);
  const order = useMemo(() => orderActions(editor, level), [editor, level]);

  const last = keys[keys.length - 1] ?? null;
  useEffect(() => {
    if (last === null) return;
    setActive((now) => (now !== null && selection.keys().includes(now) ? now : last));
    anchor.current ??= last;
  }, [last, selection]);
  // A row whose name is edited must be shown.
  useEffect(() => {
    if (renaming === null) return;
    const all = objectRows(document.file(), new Set());
    const index = all.findIndex(({ key }) => key === renaming);
    const folder = all[index]?.depth === 2 ? all.slice(0, index).findLast(({ depth }) => depth === 1) : undefined;
    if (folder !== undefined) setFolded((now) => new Set([...now].filter((key) => key !== folder.key)));
    setActive(renaming);
  }, [renaming, document]);

  const toggle = ({ key }: ObjectRow) => setFolded((now) => toggledIn(now, key));
  const pick = ({ key, expanded }: ObjectRow, { shift, mod }: Modifiers) => {
    if (expanded !== null) return;
    if (shift && anchor.current !== null) {
      selection.select(leavesBetween(rows, anchor.current, key));
      return;
    }
    anchor.current = key;
    if (mod) selection.toggle([key]);
    else selection.select([key]);
  };
  const show = ({ keys }: ObjectRow) => {
    selection.select(keys);
    commands.run('view.fit-selection');
  };
  const rename = (row: ObjectRow) => {
    if (row.found !== null || row.group !== null) session.setState({ renaming: row.key });
  };
  const move = ({ key, title }: ObjectRow, place: number) => document.change(`Reorder ${title}`, reorderObject(key, place));
  const actions = useMemo(
    (): LineActions => ({
      onLock: ({ keys, marks }) => order.lock(keys, !marks.isLocked),
      onHide: ({ keys, marks }) => order.hide(keys, !marks.isHidden),
      onRename: ({ key, group }, name) => (group === null ? order.name(key, name) : order.renameGroup(group, name)),
      problemOf({ group }, name) {
        if (group === null) return null;
        if (name === '') return 'A group needs a name: type one, or press Esc.';
        return groupsIn(document.file()).has(name) ? `There is a group ${name}: type another name.` : null;
      },
      onRenamed: () => session.setState({ renaming: null }),
    }),
    [order, document, session],
  );

  return (
    <section className="panel outliner" aria-label="Objects">
      <div className="panel__head">
        <h2 className="panel__title">Objects</h2>
        <span className="outliner__count numbers">{objectsOf(file).size}</span>
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
        onKey={(event, row) => {
          if (event.key !== 'F2') return false;
          rename(row);
          return true;
        }}
        menu={(row) => outlineMenu(row, { editor, level, rows, order, onShow: show, onToggle: toggle, onRename: rename })}
        render={(row) => (
          <ObjectLine row={row} problems={problems.get(row.key)} isRenaming={row.key === renaming} actions={actions} />
        )}
      />
      <NoteList file={file} />
    </section>
  );
});

/** The notes of the level; each goes to its place and opens there. */
function NoteList({ file }: { readonly file: LevelFile }) {
  const { session } = useEditor();
  const notes = pinnedNotesIn(file);
  if (notes.length === 0) return null;
  const go = ({ id, x, y }: PinnedNote) => {
    const { layers } = session.getState();
    session.setState({ lookAt: { x, y }, openNote: id, layers: { ...layers, notes: true } });
  };
  return (
    <section className="outliner__notes" aria-label="Notes">
      {notes.map((note) => (
        <button key={note.id} type="button" className="outliner__note" title={note.text} onClick={() => go(note)}>
          <MessageSquareText size={14} aria-hidden />
          <span className="outliner__name">{note.text}</span>
        </button>
      ))}
    </section>
  );
}

/** ms without a change before problems are looked for, which simulates every run */
const PAUSE = 300;

const NONE: ReadonlyMap<ObjectKey, readonly string[]> = new Map();

function byObject({ file, problems }: LiveProof): ReadonlyMap<ObjectKey, readonly string[]> {
  const byKey = new Map<ObjectKey, string[]>();
  for (const { pointer, message } of problems) {
    const key = keyAt(file, pointer);
    if (key !== null) byKey.set(key, [...(byKey.get(key) ?? []), message]);
  }
  return byKey;
}

/** The problems of objects of the open level, by their keys; updated a moment after the last change. */
const useProblems = (): ReadonlyMap<ObjectKey, readonly string[]> => useAtRest(useLevel().proof.store, byObject, PAUSE, NONE);

/** The objects of the open level. */
function objectDestinations({ open, commands }: Editor): readonly Destination[] {
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
