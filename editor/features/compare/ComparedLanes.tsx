import { Diff, X } from 'lucide-react';
import type { CSSProperties } from 'react';
import { useStore } from 'zustand';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { useCoarse, useEditor, useLevel, useProof, useTouch } from '../../core/context/index.ts';
import { plural } from '../../core/figures/index.ts';
import { Button } from '../../core/ui/index.ts';
import { type OnTimeline, toX } from '../../timeline/index.ts';
import { comparedOf } from './compared.ts';
import { type ComparedRow, compareOrTell, showCompared, useComparedRows } from './compared-rows.ts';
import './compare.css';

/** px of a button, and a gap */
const BUTTON = { fine: 28, coarse: 48 } as const;

/** px that the mark of an end needs to its right */
const ROOM = 76;

/** How each slot draws its holds: never by colour alone. */
const BORDERS = ['solid', 'dotted', 'dashed', 'double'] as const;

/** How it ends, in words: `completes the level at 6.32 s`. */
function endOf({ found, isGivenUp, isStale }: ComparedRow, range: number): string {
  if (found === null) return isGivenUp ? 'not simulated' : 'being simulated';
  return `${outcomeAsPredicate(found.end, range)}${isStale ? ', before the last change of the level' : ''}`;
}

/** The compared runs below the shown one, each in a lane of its own at the same scale. */
export function ComparedLanes({ scale, width }: OnTimeline) {
  const rows = useComparedRows();
  return (
    <ul className="race" aria-label="Compared runs">
      {rows.map((row) => (
        <Lane key={row.slot} row={row} scale={scale} width={width} />
      ))}
    </ul>
  );
}

function Lane({ row, scale, width }: Pick<OnTimeline, 'scale' | 'width'> & { readonly row: ComparedRow }) {
  const editor = useEditor();
  const level = useLevel();
  const touch = useTouch();
  const isCoarse = useCoarse();
  const range = useProof((proof) => proof.level.range);
  const store = comparedOf(level);
  const isAlone = useStore(store, ({ runs }) => runs.length === 1);
  const { name, number, found, holds, colour, dashes, slot, isStale, isChosen, source, key } = row;
  const words = `${number} ${name}: ${endOf(row, range)}, ${plural(holds.length, 'hold')}`;
  const end = found === null ? null : toX(scale, 60 * found.end.time);
  // the buttons stand at the right
  const free = width - (isAlone ? 1 : 2) * (isCoarse ? BUTTON.coarse : BUTTON.fine);
  const completes = found?.end.outcome === 'completed';
  return (
    <li className={isStale ? 'race__row race__row--stale' : 'race__row'} style={{ '--race': colour } as CSSProperties}>
      <button
        type="button"
        className="race__lane"
        title={touch ? words : `${words}. Click to show it`}
        onClick={() => showCompared(editor, level, source)}
      >
        <span className="unseen">{words}. Show this run</span>
        <span className="race__tag" aria-hidden>
          <svg className="race__line" width="26" height="6" aria-hidden>
            <line x1="0" y1="3" x2="26" y2="3" strokeDasharray={dashes.join(' ')} />
          </svg>
          {number} <span className="race__name">{name}</span>
          {isStale && '…'}
        </span>
        {holds.map(([press, release]) => (
          <span
            key={press}
            className="race__hold"
            style={{ left: toX(scale, press), width: Math.max(2, (release - press) * scale.zoom), borderStyle: BORDERS[slot] }}
          />
        ))}
        {end !== null && end >= 0 && end <= width && (
          <>
            <span className="race__end" style={{ left: end }} />
            <span
              aria-hidden
              className={end + ROOM > free ? 'race__time race__time--left' : 'race__time'}
              style={{ left: end + ROOM > free ? Math.min(end, free) : end }}
            >
              {completes ? '●' : '✕'} {(found?.end.time ?? 0).toFixed(2)} s
            </span>
          </>
        )}
      </button>
      <div className="race__actions">
        {!isAlone && (
          <Button
            hint={`Show the difference to ${name}`}
            pressed={isChosen}
            icon={<Diff size={13} />}
            onClick={() => store.setState({ chosen: key })}
          />
        )}
        <Button hint={`Stop comparing ${name}`} icon={<X size={13} />} onClick={() => compareOrTell(editor, level, source)} />
      </div>
    </li>
  );
}
