import { Gamepad2, Plus } from 'lucide-react';
import { type KeyboardEvent, useMemo, useState } from 'react';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { useDocument, useEditor, useLevel, useProof } from '../../context/index.ts';
import {
  addRun,
  type ChangeResult,
  deleteRun,
  duplicateRun,
  freeRunName,
  type Recipe,
  renameRun,
  reorderRun,
} from '../../document/index.ts';
import { Button } from '../../ui/index.ts';
import { plural } from '../figures/index.ts';
import { InlineName, type MenuEntry, MoreButton, Tree, type TreeRow } from '../tree/index.ts';
import { AttemptList } from './AttemptList.tsx';
import { OutcomeSign, outcomeWord } from './OutcomeSign.tsx';
import { RunHash } from './RunHash.tsx';
import { type RunSummary, useRunEnds } from './run-ends.ts';
import './runs.css';

type RunFile = NonNullable<LevelFile['runs']>[number];

interface RunRow extends TreeRow {
  readonly holds: number;
  readonly summary: RunSummary | null;
}

/** px */
const rowHeight = () => 42;
const LONGEST_NAME = 80;
const NO_RUNS: readonly RunFile[] = [];

/** The runs of the level and what was played. The one that is picked is shown on the canvas and edited in the timeline. */
export function RunsPanel() {
  const { session, commands, notices } = useEditor();
  const { document } = useLevel();
  const runs = useDocument(({ file }) => file.runs) ?? NO_RUNS;
  const shown = useProof((proof) => proof.run.name);
  const range = useProof((proof) => proof.level.range);
  const minerals = useProof((proof) => proof.level.minerals.length);
  const endOf = useRunEnds(runs);
  const [active, setActive] = useState<string | null>(null);
  const [renamed, setRenamed] = useState<string | null>(null);
  const selected = useMemo(() => new Set(shown === null ? [] : [shown]), [shown]);

  const rows = runs.map(({ name, holds }, place): RunRow => {
    const summary = endOf(name);
    const how = summary === null ? 'not played yet' : outcomeAsPredicate(summary, range);
    const label = `${name}, ${how}`;
    return {
      key: name,
      depth: 1,
      label,
      expanded: null,
      list: 'runs',
      place,
      siblings: runs.length,
      holds: holds.length,
      summary,
    };
  });

  const change = (label: string, recipe: Recipe): ChangeResult => {
    const result = document.change(label, recipe);
    if (!result.ok) notices.show('warning', `${result.refusal.message}. ${result.refusal.hint}`, { topic: 'refused' });
    return result;
  };
  const show = (name: string | null) => session.setState({ run: name, tick: 0, hoverTick: null, rolling: false });
  const add = () => {
    const name = freeRunName(document.file(), 'solution');
    if (!change('New run', addRun(name, [])).ok) return;
    show(name);
    setActive(name);
  };
  const rename = (name: string, to: string) => {
    if (!change('Rename run', renameRun(name, to)).ok) return;
    if (shown === name) session.setState({ run: to });
    setActive(to);
  };
  const nameProblem = (to: string): string | null => {
    if (to === '') return 'A run needs a name. Esc leaves it as it was.';
    const isTaken = runs.some((run) => run.name === to);
    return isTaken ? `Another run is called “${to}” already. Choose another name; Esc leaves it as it was.` : null;
  };
  const duplicate = (name: string) => {
    const as = freeRunName(document.file(), name);
    if (!change('Duplicate run', duplicateRun(name, as)).ok) return;
    show(as);
    setActive(as);
  };
  const remove = ({ key, place }: RunRow) => {
    const next = runs[place + 1]?.name ?? runs[place - 1]?.name ?? null;
    if (!change('Delete run', deleteRun(key)).ok) return;
    if (shown === key) show(next);
    setActive(next);
  };
  const move = ({ key }: RunRow, place: number) => change('Reorder runs', reorderRun(key, place));
  const onKey = (event: KeyboardEvent, row: RunRow): boolean => {
    if (event.key === 'F2') setRenamed(row.key);
    else if (event.key === 'Delete' || event.key === 'Backspace') remove(row);
    else if (event.key.toLowerCase() === 'd' && (event.ctrlKey || event.metaKey)) duplicate(row.key);
    else return false;
    return true;
  };
  const menu = (row: RunRow): readonly MenuEntry[] => [
    { title: 'Rename', keys: 'F2', run: () => setRenamed(row.key) },
    { title: 'Duplicate', run: () => duplicate(row.key) },
    { title: 'Delete', keys: 'Del', run: () => remove(row) },
    null,
    { title: 'Make it the first', disabled: row.place === 0, run: () => move(row, 0) },
    { title: 'Move up', keys: 'Alt ↑', disabled: row.place === 0, run: () => move(row, row.place - 1) },
    { title: 'Move down', keys: 'Alt ↓', disabled: row.place === row.siblings - 1, run: () => move(row, row.place + 1) },
  ];

  return (
    <section className="panel runs" aria-label="Runs">
      <div className="panel__head">
        <h2 className="panel__title">Runs</h2>
        <Button hint="New run without a press, to be drawn in the timeline" icon={<Plus size={15} />} onClick={add} />
      </div>
      {rows.length === 0 ? (
        <div className="runs__empty">
          <p>No run shows yet that this level can be completed.</p>
          <Button
            hint="Play from the start"
            shortcut="Space"
            look="main"
            icon={<Gamepad2 size={15} />}
            onClick={() => commands.run('play.start')}
          >
            Play it
          </Button>
          <p>An attempt that gets through can become the proof. Or let the solver look for one.</p>
        </div>
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
            <>
              <OutcomeSign outcome={row.summary?.outcome ?? null} />
              {row.key === renamed ? (
                <InlineName
                  label="Name of the run"
                  value={row.key}
                  longest={LONGEST_NAME}
                  problemOf={nameProblem}
                  onDone={(to) => rename(row.key, to)}
                  onEnd={() => setRenamed(null)}
                />
              ) : (
                <span className="runs__text">
                  <span className="runs__line">
                    <span className="runs__name">{row.key}</span>
                    {row.place === 0 && (
                      <span className="runs__first" title="Pictures show the first run">
                        first
                      </span>
                    )}
                    {row.summary !== null && <span className="runs__time numbers">{row.summary.time.toFixed(2)} s</span>}
                  </span>
                  <span className="runs__facts numbers">{facts(row, minerals)}</span>
                </span>
              )}
              <MoreButton />
            </>
          )}
        />
      )}
      {shown !== null && <RunHash />}
      <AttemptList />
    </section>
  );
}

function facts({ summary, holds }: RunRow, minerals: number): string {
  const held = holds === 0 ? 'no press' : plural(holds, 'hold');
  if (summary === null) return held;
  const taken = minerals === 0 ? [] : [`◆ ${summary.minerals}/${minerals}`];
  return [outcomeWord(summary.outcome), ...taken, held].join(' · ');
}
