import { useStore } from 'zustand';
import { isInView, momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { useLevel, useProof, useSession } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { onionOf } from './onion-store.ts';

const WORDS = 'before';

const wayOf = ({ run }: LiveProof): LiveProof['run']['way'] => run.way;

/** Names the end of the run as it was before a change. */
export function OnionLabel({ canvas }: Pick<OnCanvas, 'canvas'>) {
  const { proof } = useLevel();
  const points = useStore(onionOf(useLevel()), ({ former }) => former?.points ?? null);
  const isEdited = useSession(({ mode }) => mode === 'edit');
  const way = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  if (points === null || !isEdited) return null;
  const [x, y] = points.subarray(points.length - 2);
  if (!isInView(view, { x, y })) return null;
  const end = { x: way.last[0], y: way.last[1] };
  const place = momentPlace(WORDS, { x, y }, { reason: reasonOf(proof.proof()), end, way }, view);
  return (
    <div
      className="canvas__before"
      aria-hidden
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)` }}
    >
      {WORDS}
    </div>
  );
}
