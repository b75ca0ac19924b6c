import { Check, Copy, Eye, EyeOff, Plus, Trash2 } from 'lucide-react';
import { type KeyboardEvent, useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { type Attempt, attemptInWords } from '../../core/attempts/index.ts';
import { isModKey } from '../../core/commands/index.ts';
import {
  attemptGhosts,
  putGhosts,
  useDocument,
  useEditor,
  useLevel,
  useProof,
  useProofInPace,
} from '../../core/context/index.ts';
import { copyText } from '../../core/exchange/index.ts';
import { plural, seconds } from '../../core/figures/index.ts';
import { keepAsRun, makeProof } from '../../core/levels/index.ts';
import { OutcomeSign, outcomeWord, PlayButton } from '../../core/panel/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { type MenuEntry, Tree, toggledIn } from '../../core/tree/index.ts';
import { Button } from '../../core/ui/index.ts';
import { compareOrTell, sourceKey, useComparedRows } from '../compare/index.ts';
import { runChanges } from './change-runs.ts';
import { DifferencePanel } from './DifferencePanel.tsx';
import { useRunEnds } from './index.ts';
import { CompareButton, RunLine, type RunRow, runRows } from './RunLine.tsx';
import { ScriptField } from './ScriptField.tsx';

/** The attempts of this session: each is a ghost on the canvas and can be kept as a run of the level. */
export function AttemptList() {
  const editor = useEditor();
  const level = useLevel();
  const { attempts: kept, ghosts } = level;
  const attempts = useStore(kept.store);
  const range = useProof((proof) => proof.level.range);
  const compared = useComparedRows();
  const numberOf = (number: number) => compared.find(({ key }) => key === sourceKey({ kind: 'attempt', number }))?.number ?? null;
  const [hidden, setHidden] = useState<ReadonlySet<number>>(new Set());

  useEffect(() => {
    const show = () => {
      const shown = kept.store.getState().filter(({ number }) => !hidden.has(number));
      putGhosts(ghosts, 'attempt', attemptGhosts(shown));
    };
    show();
    return kept.store.subscribe(show);
  }, [ghosts, kept, hidden]);

  if (attempts.length === 0) return null;
  const allHidden = attempts.every(({ number }) => hidden.has(number));
  const toggle = ({ number }: Attempt) => setHidden((now) => toggledIn(now, number));
  return (
    <section className="attempts" aria-label="Attempts">
      <div className="panel__head">
        <h3 className="panel__title">Attempts</h3>
        <Button
          hint={allHidden ? 'Show all attempts on the canvas' : 'Hide all attempts on the canvas'}
          icon={allHidden ? <EyeOff size={14} /> : <Eye size={14} />}
          onClick={() => setHidden(new Set(allHidden ? [] : attempts.map(({ number }) => number)))}
        />
        <Button hint="Discard all attempts" icon={<Trash2 size={14} />} onClick={() => kept.clear()} />
      </div>
      <ul className="attempts__list">
        {attempts.toReversed().map((attempt) => {
          const { number, end, minerals, holds, tick } = attempt;
          const completes = end?.outcome === 'completed';
          const how = end === null ? `left at ${seconds(tick * TICK)}` : `${outcomeWord(end.outcome)} · ${seconds(end.time)}`;
          const words = `She ${attemptInWords(attempt, range)}, with ${plural(holds.length, 'hold')}.`;
          return (
            <li key={number} className="attempts__one" title={words}>
              <OutcomeSign outcome={end?.outcome ?? null} />
              <span className="runs__text">
                <span className="runs__name">attempt {number}</span>
                <span className="runs__facts numbers">
                  {how}
                  {minerals > 0 && ` · ◆ ${minerals}`}
                </span>
              </span>
              <Button
                hint={hidden.has(number) ? `Show attempt ${number} on the canvas` : `Hide attempt ${number} on the canvas`}
                icon={hidden.has(number) ? <EyeOff size={14} /> : <Eye size={14} />}
                onClick={() => toggle(attempt)}
              />
              <CompareButton
                name={`attempt ${number}`}
                compared={numberOf(number)}
                onCompare={() => compareOrTell(editor, level, { kind: 'attempt', number })}
              />
              <Button
                hint={`Keep attempt ${number} as a run`}
                icon={completes ? <Check size={14} /> : <Plus size={14} />}
                onClick={() => (completes ? makeProof : keepAsRun)({ editor, level }, attempt)}
              />
            </li>
          );
        })}
      </ul>
    </section>
  );
}

type RunFile = NonNullable<LevelFile['runs']>[number];

/** px */
const rowHeight = () => 42;
const NO_RUNS: readonly RunFile[] = [];

/**
 * The runs of the level and the attempts of this session. The selected run is shown on the canvas and edited in the timeline.
 */
export function RunsPanel() {
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
