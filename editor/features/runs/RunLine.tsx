import { plural } from '../../core/figures/index.ts';
import { OutcomeSign, outcomeWord } from '../../core/panel/index.ts';
import { InlineName, MoreButton } from '../../core/tree/index.ts';
import { CompareButton } from './CompareButton.tsx';
import type { RunRow } from './run-row.ts';

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
