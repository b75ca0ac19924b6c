import { useStore } from 'zustand';
import { momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { useLevel, useProof, useSession } from '../../core/context/index.ts';
import { isWhole, type LiveProof } from '../../core/proof/index.ts';
import { type OnTimeline, toX } from '../../timeline/index.ts';
import { accuracyNameOf, type Loss } from '../../workers/index.ts';
import { lossInWords, lossKey, lostFromInWords, lostOf } from './index.ts';

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

const wayOf = ({ run }: LiveProof): LiveProof['run']['way'] => run.way;

/** Since when the shown run is lost, beside the place where it is lost. */
export function RunLossLabel({ canvas }: Pick<OnCanvas, 'canvas'>) {
  const { proof } = useLevel();
  const loss = useRunLoss();
  const isShown = useSession(({ layers, mode }) => layers.lost && mode === 'edit');
  const way = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  const words = loss === null ? null : lostFromInWords(loss);
  const at = loss?.proved ?? loss?.lost ?? null;
  if (words === null || at === null || !isShown) return null;
  const [x, y] = way.last;
  const place = momentPlace(words, at, { reason: reasonOf(proof.proof()), end: { x, y }, way }, view);
  return (
    <div
      className={at.known === 'proved' ? 'canvas__loss' : 'canvas__loss canvas__loss--open'}
      role="note"
      aria-label="Where the run is lost"
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)` }}
    >
      {words}
    </div>
  );
}

/** Since when the shown run is lost; null if it completes the level or nothing is known. */
export function useRunLoss(): Loss | null {
  const losses = useStore(lostOf(useLevel()), (state) => state.losses);
  const key = useProof(({ run, terms }) => (run.outcome === 'completed' ? null : lossKey(run.holds, accuracyNameOf(terms))));
  return key === null ? null : (losses.get(key) ?? null);
}
