import { DoorOpen, FileQuestionMark } from 'lucide-react';
import { TICK } from '../../../engine/index.ts';
import { OutcomeSign } from '../runs/index.ts';
import { MoreButton } from '../tree/index.ts';
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
  /** Since when it was lost, in words; null: not known, or not lost. */
  readonly since: string | null;
}

/** An attempt or a play in the list. */
export function AttemptLine({ row, minerals: all, since }: AttemptLineProps) {
  const { title, end, tick, minerals, verdict, outcome } = row;
  return (
    <span className="attempt-line" title={since === null ? `${title}: ${end}` : `${title}: ${end} ${since}`}>
      <Sign outcome={outcome} />
      <span className="runs__text">
        <span className="runs__line">
          <span className="runs__name">{title}</span>
          <span className="runs__time numbers">
            {all > 0 && `◆ ${minerals}/${all} · `}
            {(tick * TICK).toFixed(2)} s
          </span>
        </span>
        <span className="runs__facts numbers">
          {verdict !== null && verdict !== 'ok' && <b className="attempt-line__verdict">{verdict} </b>}
          {end}
        </span>
        {since !== null && <span className="runs__facts attempt-line__since numbers">{since}</span>}
      </span>
      <MoreButton />
    </span>
  );
}
