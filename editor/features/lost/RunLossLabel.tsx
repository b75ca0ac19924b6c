import { useStore } from 'zustand';
import { momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { useLevel, useProof, useSession } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { lostFromInWords } from './loss-words.ts';
import { useRunLoss } from './use-run-loss.ts';

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
