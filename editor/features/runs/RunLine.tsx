import { GitCompare } from 'lucide-react';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { plural } from '../../core/figures/index.ts';
import { OutcomeSign, outcomeWord } from '../../core/panel/index.ts';
import { InlineName, MoreButton, type TreeRow } from '../../core/tree/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { RunSummary } from './index.ts';

const LONGEST_NAME = 80;

interface RunLineProps {
  readonly row: RunRow;
  /** The number of minerals in the level. */
  readonly minerals: number;
  /** Its number among the compared runs; null: it is not compared. */
  readonly compared: number | null;
  /** Puts it beside the shown run, or takes it away; null: it is the shown one. */
  readonly onCompare: (() => void) | null;
  /** Whether its name is being edited. */
  readonly isRenamed: boolean;
  /** Why a name is refused; null if it is fine. */
  readonly problemOf: (name: string) => string | null;
  readonly onRename: (to: string) => void;
  readonly onRenamed: () => void;
}

/** A run in the list. */
export function RunLine({ row, minerals, compared, onCompare, isRenamed, problemOf, onRename, onRenamed }: RunLineProps) {
  return (
    <>
      <OutcomeSign outcome={row.summary?.outcome ?? null} />
      {isRenamed ? (
        <InlineName
          label="Run name"
          value={row.key}
          longest={LONGEST_NAME}
          problemOf={problemOf}
          onDone={onRename}
          onEnd={onRenamed}
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
            {onCompare !== null && <CompareButton isInList name={row.key} compared={compared} onCompare={onCompare} />}
          </span>
          <span className="runs__facts numbers">{facts(row, minerals)}</span>
        </span>
      )}
      <MoreButton />
    </>
  );
}

function facts({ summary, holds }: RunRow, minerals: number): string {
  const held = holds === 0 ? 'no holds' : plural(holds, 'hold');
  if (summary === null) return held;
  const taken = minerals === 0 ? [] : [`◆ ${summary.minerals}/${minerals}`];
  return [outcomeWord(summary.outcome), ...taken, held].join(' · ');
}

interface CompareButtonProps {
  readonly name: string;
  /** Its number among the compared runs; null: it is not compared. */
  readonly compared: number | null;
  readonly onCompare: () => void;
  /** Whether it stands in a list in which keys do the same: then Tab passes it by. */
  readonly isInList?: boolean;
}

/** Puts a run or an attempt beside the shown run, or takes it away. */
export function CompareButton({ name, compared, onCompare, isInList = false }: CompareButtonProps) {
  return (
    <Button
      hint={compared === null ? `Compare ${name} with the shown run` : `Stop comparing ${name}, which is number ${compared}`}
      pressed={compared !== null}
      className="runs__compare"
      tabIndex={isInList ? -1 : undefined}
      icon={<GitCompare size={14} />}
      onClick={(event) => {
        // the row around it would show the run
        event.stopPropagation();
        onCompare();
      }}
    />
  );
}

/** A run as the list shows it. */
export interface RunRow extends TreeRow {
  readonly holds: number;
  /** null if it is not simulated yet */
  readonly summary: RunSummary | null;
}

interface RunInList {
  readonly name: string;
  readonly holds: readonly unknown[];
}

/** @param range of the level, px */
export function runRows(runs: readonly RunInList[], endOf: (name: string) => RunSummary | null, range: number): RunRow[] {
  return runs.map(({ name, holds }, place) => {
    const summary = endOf(name);
    const how = summary === null ? 'not simulated yet' : outcomeAsPredicate(summary, range);
    return {
      key: name,
      depth: 1,
      label: `${name}, ${how}`,
      expanded: null,
      list: 'runs',
      place,
      siblings: runs.length,
      holds: holds.length,
      summary,
    };
  });
}
