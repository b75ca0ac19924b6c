import { useProof, useSession } from '../../core/context/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import { type OnTimeline, toX } from '../../timeline/index.ts';
import { lossInWords, lostFromInWords } from './loss-words.ts';
import { useRunLoss } from './use-run-loss.ts';

/** px that the words need to the right of the mark */
const ROOM = 190;

/** Since when the shown run is lost: a stripe until its end, dots where no run was found, strokes where it is proved. */
export function LossMark({ scale, width, end }: OnTimeline) {
  const loss = useRunLoss();
  const isShown = useSession(({ layers }) => layers.lost);
  const time = useProof((proof) => (isWhole(proof) ? proof.run.time : null));
  if (!isShown || loss === null || time === null) return null;
  const words = lostFromInWords(loss);
  const all = lossInWords(loss, time);
  const { lost, proved } = loss;
  const first = proved ?? lost;
  if (words === null || all === null || first === null) return null;
  const stripe = (from: number, to: number, look: string) => {
    const [left, right] = [Math.max(0, toX(scale, from)), Math.min(width, toX(scale, to))];
    return right > left && <div className={`timeline__loss timeline__loss--${look}`} style={{ left, width: right - left }} />;
  };
  const x = toX(scale, first.tick);
  const isIn = x >= 0 && x <= width;
  return (
    <div className="timeline__losses" role="img" aria-label={all} title={all}>
      {lost !== null && (proved === null || lost.tick < proved.tick) && stripe(lost.tick, proved?.tick ?? end, 'open')}
      {proved !== null && stripe(proved.tick, end, 'proved')}
      {isIn && (
        <div className={first.known === 'proved' ? 'timeline__lost' : 'timeline__lost timeline__lost--open'} style={{ left: x }}>
          <span className={x + ROOM > width ? 'timeline__since timeline__since--left' : 'timeline__since'}>{words}</span>
        </div>
      )}
    </div>
  );
}
