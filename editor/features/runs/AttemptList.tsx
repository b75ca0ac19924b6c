import { Check, Eye, EyeOff, Plus, Trash2 } from 'lucide-react';
import { useEffect, useState } from 'react';
import { useStore } from 'zustand';
import { TICK } from '../../../engine/index.ts';
import { type Attempt, attemptInWords } from '../../core/attempts/index.ts';
import { attemptGhosts, putGhosts, useEditor, useLevel, useProof } from '../../core/context/index.ts';
import { plural, seconds } from '../../core/figures/index.ts';
import { keepAsRun, makeProof } from '../../core/levels/index.ts';
import { OutcomeSign, outcomeWord } from '../../core/panel/index.ts';
import { toggledIn } from '../../core/tree/index.ts';
import { Button } from '../../core/ui/index.ts';
import { compareOrTell, sourceKey, useComparedRows } from '../compare/index.ts';
import { CompareButton } from './RunLine.tsx';

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
