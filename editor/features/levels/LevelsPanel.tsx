import { FilePlus2, LayoutGrid, Search, Trash2 } from 'lucide-react';
import { type KeyboardEvent, useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import type { LevelEntry } from '../../../schema/index.ts';
import { isModKey } from '../../core/commands/index.ts';
import { useEditor } from '../../core/context/index.ts';
import { errorInWords } from '../../core/files/index.ts';
import { deleteLevel, duplicateLevel, followSaves, openListed } from '../../core/levels/index.ts';
import { laterDialog, SamplesButton, TextDialog } from '../../core/panel/index.ts';
import { Tree, toggledIn } from '../../core/tree/index.ts';
import { Button, focusHome } from '../../core/ui/index.ts';
import { FolderLine, LevelLine } from './LevelLine.tsx';
import { copyPath, type LevelRow, levelMenu, levelRows, moveTo } from './level-rows.ts';
import './levels.css';

const RenameDialog = laterDialog(() => import('./RenameDialog.tsx').then((there) => there.RenameDialog));

/** px */
const rowHeight = ({ entry }: LevelRow) => (entry === null ? 28 : 54);
const NO_LEVELS = [] as const;

/** The levels of the folder with their pictures and verdicts; opens, renames, reorders and deletes them. */
export function LevelsPanel() {
  const editor = useEditor();
  const { workspace, session } = editor;
  const list = useStore(workspace.store, (state) => state.list);
  const error = useStore(workspace.store, (state) => state.error);
  const open = useStore(editor.open);
  const opened = useStore(workspace.store, (state) => state.opened?.id() ?? null);
  const [active, setActive] = useState<string | null>(opened);
  const [search, setSearch] = useState('');
  const [folded, setFolded] = useState<ReadonlySet<string>>(new Set());
  const [renamed, setRenamed] = useState<string | null>(null);
  const [asText, setAsText] = useState<LevelEntry | null>(null);
  const levels = list?.levels ?? NO_LEVELS;
  const rows = useMemo(() => levelRows(levels, folded, search), [levels, folded, search]);
  const selected = useMemo(() => new Set(opened === null ? [] : [opened]), [opened]);

  useEffect(() => followSaves(editor), [editor]);
  useEffect(() => {
    if (opened !== null) setActive(opened);
  }, [opened]);
  const pick = ({ entry }: LevelRow) => {
    if (entry === null) return;
    if (entry.status !== 'valid') setAsText(entry);
    else if (entry.id !== opened) void openListed(editor, entry.id);
  };
  /** Opens the first match; the keyboard then works on the level. */
  const openFirst = (): boolean => {
    const first = rows.find(({ entry }) => entry !== null);
    if (first === undefined) return false;
    setSearch('');
    focusHome();
    pick(first);
    return true;
  };
  const onKey = (event: KeyboardEvent, { entry }: LevelRow): boolean => {
    if (entry === null) return false;
    if (event.key === 'F2') setRenamed(entry.id);
    else if (event.key === 'Delete' || event.key === 'Backspace') void deleteLevel(editor, entry);
    else if (isModKey(event, 'd')) void duplicateLevel(editor, entry);
    else if (isModKey(event, 'c')) void copyPath(editor, entry.file);
    else return false;
    return true;
  };
  const menu = (row: LevelRow) =>
    levelMenu(editor, levels, row, { opened, onOpen: () => pick(row), onText: setAsText, onRename: setRenamed });

  return (
    <section className="panel levels" aria-label="Levels">
      <div className="panel__head">
        <LevelSearch count={levels.length} text={search} onChange={setSearch} onOpenFirst={openFirst} />
        <Button
          hint="New level"
          shortcut="Alt N"
          icon={<FilePlus2 size={15} />}
          onClick={() => session.setState({ overlay: 'newLevel' })}
        />
        <Button
          hint="All levels as cards"
          shortcut="Shift P"
          icon={<LayoutGrid size={15} />}
          onClick={() => session.setState({ view: 'pack' })}
        />
        <Button hint="Deleted levels" icon={<Trash2 size={15} />} onClick={() => session.setState({ overlay: 'trash' })} />
      </div>
      {error !== null && open !== null && (
        <p className="levels__trouble" role="alert">
          {errorInWords(error)}
        </p>
      )}
      {list?.troubles.map((trouble) => (
        <p key={trouble} className="levels__trouble" role="alert">
          {trouble}
        </p>
      ))}
      {rows.length > 0 ? (
        <Tree
          label="Levels"
          rows={rows}
          rowHeight={rowHeight}
          selected={selected}
          active={active}
          onActive={setActive}
          onPick={pick}
          onToggle={({ title }) => setFolded((now) => toggledIn(now, title))}
          onMove={({ entry }, place) => moveTo(editor, levels, entry, place)}
          onKey={onKey}
          menu={menu}
          render={({ entry, title, expanded, count }) =>
            entry === null ? (
              <FolderLine title={title} isOpen={expanded === true} count={count} />
            ) : (
              <LevelLine entry={entry} title={title} open={open?.opened.id() === entry.id ? open : null} />
            )
          }
        />
      ) : list === null ? (
        error === null && <p className="levels__empty">Loading levels…</p>
      ) : levels.length > 0 ? (
        <p className="levels__empty">No levels match "{search}".</p>
      ) : (
        <NoLevels folder={list.folder.path} />
      )}
      {renamed !== null && <RenameDialog id={renamed} onClose={() => setRenamed(null)} />}
      {asText !== null && <TextDialog id={asText.id} fromDisk={asText.status !== 'valid'} onClose={() => setAsText(null)} />}
    </section>
  );
}

interface LevelSearchProps {
  /** The number of levels. */
  readonly count: number;
  readonly text: string;
  readonly onChange: (text: string) => void;
  /** Opens the first match. @returns whether there is one */
  readonly onOpenFirst: () => boolean;
}

/** Finds levels by name. */
function LevelSearch({ count, text, onChange, onOpenFirst }: LevelSearchProps) {
  return (
    <label className="levels__search">
      <Search size={13} aria-hidden />
      <input
        type="search"
        className="field"
        placeholder={count === 1 ? 'Find in 1 level' : `Find in ${count} levels`}
        aria-label="Find a level"
        value={text}
        onChange={(event) => onChange(event.target.value)}
        onKeyDown={(event) => {
          if (event.key === 'Escape' && text !== '') onChange('');
          else if (event.key === 'Escape') focusHome();
          else if (event.key !== 'Enter' || !onOpenFirst()) return;
          event.preventDefault();
        }}
      />
    </label>
  );
}

/** The empty state of a folder without levels. @param folder the path as the user gave it */
function NoLevels({ folder }: { readonly folder: string }) {
  const { session } = useEditor();
  return (
    <div className="levels__empty">
      <p>No levels in {folder} yet.</p>
      <Button hint="Start from a template" look="main" onClick={() => session.setState({ overlay: 'newLevel' })}>
        New level
      </Button>
      <Button hint="From files or from the original game" look="outlined" onClick={() => session.setState({ overlay: 'open' })}>
        Import levels
      </Button>
      <SamplesButton />
    </div>
  );
}
