import { useState } from 'react';
import { plural } from '../../core/figures/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Difference, DifferencePart } from './use-comparison.ts';

interface DifferenceListProps {
  /** null while they are not known */
  readonly differences: readonly Difference[] | null;
  readonly title: string;
  /** Said where there are none. */
  readonly same: string;
  /** Takes parts back. @returns whether it did; null: they can only be looked at */
  readonly onTakeBack: ((parts: readonly DifferencePart[]) => boolean) | null;
}

/** The most differences that are listed; more are counted. */
const MOST = 300;

/** What differs, grouped by object; parts can be chosen and taken back. */
export function DifferenceList({ differences, title, same, onTakeBack }: DifferenceListProps) {
  const [chosen, setChosen] = useState<ReadonlySet<string>>(new Set());
  if (differences === null) return <p className="history__empty">Comparing…</p>;
  if (differences.length === 0) return <p className="history__empty">{same}</p>;
  const parts = differences.flatMap((difference) => difference.parts);
  const wanted = parts.filter(({ key }) => chosen.has(key));
  const choose = (keys: readonly string[], isChosen: boolean) =>
    setChosen(new Set([...[...chosen].filter((key) => !keys.includes(key)), ...(isChosen ? keys : [])]));
  const line = (part: DifferencePart) => (
    <li key={part.key} className="history__part">
      {onTakeBack === null ? (
        part.words
      ) : (
        <label className="history__choice">
          <input
            type="checkbox"
            checked={chosen.has(part.key)}
            onChange={({ currentTarget }) => choose([part.key], currentTarget.checked)}
          />
          {part.words}
        </label>
      )}
    </li>
  );
  const takeAway = () => {
    if (onTakeBack?.(wanted) === true) setChosen(new Set());
  };
  return (
    <div className="history__differences">
      <h4 className="history__subtitle">{title}</h4>
      <ul className="history__changes">
        {differences.slice(0, MOST).map((difference) => {
          if (difference.title === null) return difference.parts.map(line);
          const keys = difference.parts.map(({ key }) => key);
          return (
            <li key={difference.key} className="history__group">
              {onTakeBack === null ? (
                difference.title
              ) : (
                <label className="history__choice">
                  <input
                    type="checkbox"
                    ref={(box) => {
                      if (box !== null)
                        box.indeterminate = keys.some((key) => chosen.has(key)) && !keys.every((key) => chosen.has(key));
                    }}
                    checked={keys.every((key) => chosen.has(key))}
                    onChange={({ currentTarget }) => choose(keys, currentTarget.checked)}
                  />
                  {difference.title}
                </label>
              )}
              <ul className="history__changes">{difference.parts.map(line)}</ul>
            </li>
          );
        })}
        {differences.length > MOST && (
          <li>and {plural(differences.length - MOST, 'more difference')}; Restore takes all of them back</li>
        )}
      </ul>
      {onTakeBack !== null && (
        <Button
          className="history__take"
          hint="Take the chosen changes back, as one step that can be undone"
          look="outlined"
          disabled={wanted.length === 0}
          onClick={takeAway}
        >
          {wanted.length === 0 ? 'Take back what is chosen' : `Take back ${plural(wanted.length, 'change')}`}
        </Button>
      )}
    </div>
  );
}
