import { Copy, Plus, Waypoints } from 'lucide-react';
import { type KeyboardEvent, useMemo, useState } from 'react';
import { flushSync } from 'react-dom';
import type { LevelFile } from '../../../schema/index.ts';
import { type Destination, isModKey } from '../../core/commands/index.ts';
import { type Editor, perLevel, useDocument, useEditor, useLevel, useProof, useProofInPace } from '../../core/context/index.ts';
import { PlayButton } from '../../core/panel/index.ts';
import { type MenuEntry, Tree } from '../../core/tree/index.ts';
import { Button } from '../../core/ui/index.ts';
import { compareOrTell, sourceKey, useComparedRows } from '../compare/index.ts';
import type { Feature } from '../feature.ts';
import { AttemptList } from './AttemptList.tsx';
import { runChanges } from './change-runs.ts';
import { DifferencePanel } from './DifferencePanel.tsx';
import { useRunEnds } from './index.ts';
import { RunLine, type RunRow, runRows } from './RunLine.tsx';
import { SCRIPT_FIELD, ScriptField } from './ScriptField.tsx';
import './runs.css';
import { copyText } from '../../core/exchange/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';

/** The runs of the open level. */
function runDestinations({ open, session }: Editor): readonly Destination[] {
  return (open.getState()?.document.file().runs ?? []).map(({ name, holds }) => ({
    key: `run ${name}`,
    group: 'Run',
    title: name,
    detail: `${holds.length} ${holds.length === 1 ? 'hold' : 'holds'}`,
    go: () => session.setState({ run: name }),
  }));
}

/** The runs of the level: how they end, and the shown one as text. */
export const runs: Feature = {
  name: 'runs',
  panel: {
    id: 'runs',
    title: 'Runs',
    icon: <Waypoints size={17} />,
    side: 'left',
    place: 'tab',
    content: perLevel(RunsPanel),
  },
  destinations: runDestinations,
  commands: ({ open, commands }) => [
    {
      id: 'run.text',
      title: 'Edit the run as text',
      group: 'Run',
      keys: ['t'],
      needs: () => (open.getState()?.proof.proof().run.name == null ? 'show a run first' : null),
      run: () => {
        flushSync(() => commands.run('panel.runs'));
        document.getElementById(SCRIPT_FIELD)?.focus();
      },
    },
  ],
};

type RunFile = NonNullable<LevelFile['runs']>[number];

/** px */
const rowHeight = () => 42;
const NO_RUNS: readonly RunFile[] = [];

/**
 * The runs of the level and the attempts of this session. The selected run is shown on the canvas and edited in the timeline.
 */
function RunsPanel() {
  const editor = useEditor();
  const level = useLevel();
  const runs = useDocument(({ file }) => file.runs) ?? NO_RUNS;
  const shown = useProof((proof) => proof.run.name);
  const range = useProof((proof) => proof.level.range);
  const minerals = useProof((proof) => proof.level.minerals.length);
  const endOf = useRunEnds(runs);
  const compared = useComparedRows();
  const [active, setActive] = useState<string | null>(null);
  const [renamed, setRenamed] = useState<string | null>(null);
  const selected = useMemo(() => new Set(shown === null ? [] : [shown]), [shown]);
  const rows = runRows(runs, endOf, range);
  const { show, move, ...changes } = runChanges(editor, level, shown);

  /** Makes the run that results from a change the active one. */
  const goOn = (name: string | null | undefined) => {
    if (name !== undefined) setActive(name);
  };
  const problemOf = (to: string): string | null => {
    if (to === '') return 'A run needs a name. Press Esc to keep the old one.';
    const isTaken = runs.some((run) => run.name === to);
    return isTaken ? `Another run is called “${to}”. Choose another name, or press Esc to keep the old one.` : null;
  };
  const onKey = (event: KeyboardEvent, row: RunRow): boolean => {
    if (event.key === 'F2') setRenamed(row.key);
    else if (event.key === 'Delete' || event.key === 'Backspace') goOn(changes.remove(row));
    else if (event.key === 'c' && !event.ctrlKey && !event.metaKey) compare(row.key);
    else if (isModKey(event, 'd')) goOn(changes.duplicate(row.key));
    else return false;
    return true;
  };
  const compare = (name: string) => compareOrTell(editor, level, { kind: 'run', name });
  const numbers = new Map(compared.map(({ key, number }) => [key, number]));
  const numberOf = (name: string) => numbers.get(sourceKey({ kind: 'run', name })) ?? null;
  const menu = (row: RunRow): readonly MenuEntry[] => [
    {
      title: numberOf(row.key) === null ? 'Compare' : 'Stop comparing',
      keys: 'C',
      disabled: row.key === shown,
      run: () => compare(row.key),
    },
    null,
    { title: 'Rename', keys: 'F2', run: () => setRenamed(row.key) },
    { title: 'Duplicate', run: () => goOn(changes.duplicate(row.key)) },
    { title: 'Delete', keys: 'Del', run: () => goOn(changes.remove(row)) },
    null,
    { title: 'Move to top', disabled: row.place === 0, run: () => move(row, 0) },
    { title: 'Move up', keys: 'Alt ↑', disabled: row.place === 0, run: () => move(row, row.place - 1) },
    { title: 'Move down', keys: 'Alt ↓', disabled: row.place === row.siblings - 1, run: () => move(row, row.place + 1) },
  ];

  return (
    <section className="panel runs" aria-label="Runs">
      <div className="panel__head">
        <h2 className="panel__title">Runs</h2>
        <Button hint="New empty run" icon={<Plus size={15} />} onClick={() => goOn(changes.add())} />
      </div>
      {rows.length === 0 ? (
        <NoRuns />
      ) : (
        <Tree
          label="Runs of the level"
          rows={rows}
          rowHeight={rowHeight}
          follows
          selected={selected}
          active={active ?? shown}
          onActive={setActive}
          onPick={({ key }) => key !== shown && show(key)}
          onOpen={({ key }) => setRenamed(key)}
          onMove={move}
          onKey={onKey}
          menu={menu}
          render={(row) => (
            <RunLine
              row={row}
              minerals={minerals}
              compared={numberOf(row.key)}
              onCompare={row.key === shown ? null : () => compare(row.key)}
              isRenamed={row.key === renamed}
              problemOf={problemOf}
              onRename={(to) => goOn(changes.rename(row.key, to))}
              onRenamed={() => setRenamed(null)}
            />
          )}
        />
      )}
      <div className="runs__more">
        {shown !== null && <ScriptField key={shown} run={shown} />}
        {shown !== null && <RunHash />}
        <DifferencePanel />
        <AttemptList />
      </div>
    </section>
  );
}

/** The empty state of a level without runs. */
function NoRuns() {
  return (
    <div className="runs__empty">
      <p>This level has no runs yet.</p>
      <PlayButton />
      <p>Keep an attempt as a run, or let the solver find one.</p>
    </div>
  );
}

/** ms between two updates: a hash covers every tick of the run */
const WAIT = 300;

const hashOf = ({ full }: LiveProof): string => full?.hash ?? '(work limit)';

/**
 * The hash of the shown run. It equals that of `gq simulate` at the same accuracy, in any browser, if the page computes the
 * same bits.
 */
function RunHash() {
  const { notices } = useEditor();
  const hash = useProofInPace(hashOf, WAIT);
  const accuracy = useProof(({ terms }) => terms.accuracy.name);
  return (
    <p className="runs__hash">
      <span>hash</span>
      <output className="numbers" aria-label="Hash of the run" title={`gq simulate prints the same at --accuracy ${accuracy}`}>
        {hash}
      </output>
      <Button
        hint="Copy the hash of the run"
        icon={<Copy size={13} />}
        onClick={() => void copyText(notices, 'the hash of the run', hash)}
      />
    </p>
  );
}
