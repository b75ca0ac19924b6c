import { FolderOpen, X } from 'lucide-react';
import { type KeyboardEvent, useCallback, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { joinHolds } from '../../../engine/index.ts';
import { useEditor, useLevel, useProof, useProofInPace } from '../../core/context/index.ts';
import { plural } from '../../core/figures/index.ts';
import { PlayButton, Progress } from '../../core/panel/index.ts';
import { type Reading, readingOf } from '../../core/plays/index.ts';
import { hashNow, shelfOf } from '../../core/shelf/index.ts';
import { leavesBetween, type Modifiers, Tree, toggledIn } from '../../core/tree/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Loss } from '../../workers/index.ts';
import { type LostFindings, lossKey, lostFromInWords, lostOf } from '../lost/index.ts';
import { AttemptLine, replayRow, rowMenu } from './AttemptLine.tsx';
import { type AttemptRow, attemptRows, type ListOptions, type Shown, type Sort } from './attempt-rows.ts';
import { DeathList } from './DeathList.tsx';

/** px, without and with a line that says since when the attempt was lost */
const HEIGHTS = [42, 58] as const;

const SORT_TITLES: Readonly<Record<Sort, string>> = {
  newest: 'Newest first',
  oldest: 'Oldest first',
  shortest: 'Shortest first',
  longest: 'Longest first',
  minerals: 'Most minerals first',
  name: 'By name',
};
const SHOWN_TITLES: Readonly<Record<Shown, string>> = {
  all: 'All',
  completed: 'Completed',
  failed: 'Failed',
  left: 'Left before the end',
  mine: 'Your own',
  opened: 'Opened plays',
  differs: 'Not as they claim',
};
const FIRST: ListOptions = { sort: 'newest', shown: 'all', words: '' };

/** Since when an attempt was lost; null if it is not known or it was not. */
function lossOfRow(losses: LostFindings['losses'], { outcome, holds, accuracy }: AttemptRow): Loss | null {
  if (losses.size === 0 || outcome === 'completed') return null;
  const loss = losses.get(lossKey(joinHolds(holds), accuracy));
  return loss === undefined || lostFromInWords(loss) === null ? null : loss;
}

/** The attempts of the person and the opened plays of the level. Those that are selected are shown on the canvas. */
export function AttemptsPanel() {
  const editor = useEditor();
  const level = useLevel();
  const { store, select } = useMemo(() => shelfOf(level), [level]);
  const attempts = useStore(level.attempts.store);
  const plays = useStore(store, (state) => state.plays);
  const selected = useStore(store, (state) => state.selected);
  const reading = useStore(readingOf(editor));
  const trouble = useStore(editor.attempts.trouble);
  const range = useProof((proof) => proof.level.range);
  const minerals = useProof((proof) => proof.level.minerals.length);
  const losses = useStore(lostOf(level), (state) => state.losses);
  const [options, setOptions] = useState(FIRST);
  const [active, setActive] = useState<string | null>(null);
  const rows = useMemo(() => attemptRows(attempts, plays, options, range), [attempts, plays, options, range]);

  const pick = ({ key }: AttemptRow, { shift, mod }: Modifiers) => {
    if (shift && active !== null) select(leavesBetween(rows, active, key));
    else if (mod) select(toggledIn(selected, key));
    else select([key]);
  };
  const onKey = (event: KeyboardEvent, { attempt }: AttemptRow): boolean => {
    if (event.key === 'Escape' && selected.size > 0) select([]);
    else if ((event.key === 'Delete' || event.key === 'Backspace') && attempt !== null) level.attempts.remove(attempt.number);
    else return false;
    return true;
  };
  const all = attempts.length + plays.length;
  const heightOf = useCallback((row: AttemptRow) => HEIGHTS[lossOfRow(losses, row) === null ? 0 : 1], [losses]);

  return (
    <section className="panel attempts-panel" aria-label="Attempts and plays">
      <div className="panel__head">
        <h2 className="panel__title">Attempts</h2>
        {plays.length > 0 && (
          <Button hint="Close all opened plays" icon={<X size={15} />} onClick={() => editor.commands.run('plays.close')} />
        )}
        <Button hint="Open plays…" icon={<FolderOpen size={15} />} onClick={() => editor.commands.run('plays.open')} />
      </div>
      {trouble !== null && attempts.length > 0 && (
        <p className="attempts-panel__note" role="note">
          {trouble}
        </p>
      )}
      {reading !== null && <ReadingLine reading={reading} />}
      {all === 0 ? (
        <NoAttempts />
      ) : (
        <>
          <Changed />
          <Filters options={options} onChange={setOptions} shown={rows.length} all={all} />
          <Tree
            label="Attempts at the level"
            rows={rows}
            rowHeight={heightOf}
            multiple
            follows
            selected={selected}
            active={active}
            onActive={setActive}
            onPick={pick}
            onOpen={(row) => replayRow(editor, level, row)}
            onKey={onKey}
            menu={(row) => rowMenu(editor, level, row)}
            render={(row) => <AttemptLine row={row} minerals={minerals} loss={lossOfRow(losses, row)} />}
          />
          <DeathList />
        </>
      )}
    </section>
  );
}

/** What is being read, and a way to stop it. */
function ReadingLine({ reading: { what, done, of, cancel } }: { readonly reading: Reading }) {
  const words = what === 'files' ? `Reading ${of} files…` : `Verifying plays: ${done} of ${of}`;
  return (
    <div className="attempts-panel__reading">
      <span className="numbers">{words}</span>
      <Progress label="Plays" isRunning share={what === 'files' ? undefined : done / of} />
      <Button hint="Stop: these plays are not opened" look="outlined" onClick={cancel}>
        Cancel
      </Button>
    </div>
  );
}

/** Says that the plays are of an earlier version of the level. */
function Changed() {
  const level = useLevel();
  const of = useStore(shelfOf(level).store, (state) => state.of);
  // the hash is computed anew only if the level has changed
  useProofInPace((proof) => proof.level);
  if (of === null || hashNow(level) === of.hash) return null;
  return (
    <p className="attempts-panel__note" role="note">
      The level has changed since these plays. They, and the deaths on the canvas, are those of the level before.
    </p>
  );
}

interface FiltersProps {
  readonly options: ListOptions;
  readonly onChange: (options: ListOptions) => void;
  readonly shown: number;
  readonly all: number;
}

/** Search, filter and order. */
function Filters({ options, onChange, shown: count, all }: FiltersProps) {
  return (
    <div className="attempts-panel__filters">
      <input
        type="search"
        className="field"
        aria-label="Search attempts"
        placeholder="Search: name, nova 3, lost…"
        value={options.words}
        onChange={(event) => onChange({ ...options, words: event.target.value })}
      />
      <Choice label="Show" titles={SHOWN_TITLES} value={options.shown} onChange={(shown) => onChange({ ...options, shown })} />
      <Choice label="Order" titles={SORT_TITLES} value={options.sort} onChange={(sort) => onChange({ ...options, sort })} />
      <span className="attempts-panel__count numbers" role="status">
        {count === all ? plural(all, 'attempt') : `${count} of ${all} attempts`}
      </span>
    </div>
  );
}

interface ChoiceProps<T extends string> {
  readonly label: string;
  readonly titles: Readonly<Record<T, string>>;
  readonly value: T;
  readonly onChange: (value: T) => void;
}

/** One of some values, by their titles. */
function Choice<T extends string>({ label, titles, value, onChange }: ChoiceProps<T>) {
  return (
    <select className="field" aria-label={label} value={value} onChange={(event) => onChange(event.target.value as T)}>
      {Object.entries<string>(titles).map(([one, title]) => (
        <option key={one} value={one}>
          {title}
        </option>
      ))}
    </select>
  );
}

/** How to get attempts. */
function NoAttempts() {
  const { commands } = useEditor();
  return (
    <div className="attempts-panel__empty">
      <p>Nobody has played this level here yet.</p>
      <PlayButton />
      <p>
        Or open plays of others: <code>.gqr</code> files, as the game saves and sends them. Drop files or a folder of them
        anywhere on the page, or paste a play that was copied as text.
      </p>
      <span className="attempts-panel__buttons">
        <Button hint="Choose .gqr files" look="outlined" onClick={() => commands.run('plays.open')}>
          Open plays…
        </Button>
        <Button hint="Choose a folder of .gqr files" look="outlined" onClick={() => commands.run('plays.open-folder')}>
          Open a folder…
        </Button>
      </span>
    </div>
  );
}
