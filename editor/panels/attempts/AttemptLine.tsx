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

/** An attempt or a play in the list. @param minerals of the level */
export function AttemptLine({ row, minerals: all }: { readonly row: AttemptRow; readonly minerals: number }) {
  const { title, end, tick, minerals, verdict, outcome } = row;
  return (
    <span className="attempt-line" title={`${title}: ${end}`}>
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
      </span>
      <MoreButton />
    </span>
  );
}
