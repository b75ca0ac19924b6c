import { DoorOpen, FileQuestionMark } from 'lucide-react';
import { TICK } from '../../../engine/index.ts';
import { OutcomeSign } from '../../core/panel/index.ts';
import { MoreButton } from '../../core/tree/index.ts';
import type { Loss } from '../../workers/index.ts';
import { lostFromInWords, sinceInWords } from '../lost/index.ts';
import type { AttemptRow } from './attempt-rows.ts';

function Sign({ outcome }: Pick<AttemptRow, 'outcome'>) {
  if (outcome !== null && outcome !== 'left') return <OutcomeSign outcome={outcome} />;
  const Icon = outcome === null ? FileQuestionMark : DoorOpen;
  return (
    <span className={outcome === null ? 'runs__sign runs__sign--warn' : 'runs__sign'}>
      <Icon size={15} aria-hidden />
    </span>
  );
}

interface AttemptLineProps {
  readonly row: AttemptRow;
  /** Of the level. */
  readonly minerals: number;
  /** Since when it was lost; null: not known, or not lost. */
  readonly loss: Loss | null;
}

/** An attempt or a play in the list. */
export function AttemptLine({ row, minerals: all, loss }: AttemptLineProps) {
  const { title, end, tick, minerals, verdict, outcome } = row;
  return (
    <span className="attempt-line" title={loss === null ? `${title}: ${end}` : `${title}: ${end} It is ${sinceInWords(loss)}.`}>
      <Sign outcome={outcome} />
      <span className="runs__text">
        <span className="runs__line">
          <span className="runs__name">{title}</span>
          <span className="runs__time numbers">
            {all > 0 && minerals !== null && `◆ ${minerals}/${all} · `}
            {(tick * TICK).toFixed(2)} s
          </span>
        </span>
        <span className="runs__facts numbers">
          {verdict !== null && verdict !== 'ok' && <b className="attempt-line__verdict">{verdict} </b>}
          {end}
        </span>
        {loss !== null && <span className="runs__facts attempt-line__since numbers">{lostFromInWords(loss)}</span>}
      </span>
      <MoreButton />
    </span>
  );
}
