import { type StoreApi, useStore } from 'zustand';
import { useEditor, useProof, useSession } from '../core/context/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { reasonOf, reasonPlace } from './labels.ts';

const endX = ({ run }: LiveProof): number => run.way.last[0];
const endY = ({ run }: LiveProof): number => run.way.last[1];
const wayOf = ({ run }: LiveProof): LiveProof['run']['way'] => run.way;

/** Why the shown run fails, beside the place where it fails. */
export function EndReason({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const { settings } = useEditor();
  const isEdited = useSession(({ mode }) => mode === 'edit');
  const inPlay = useStore(settings, ({ runInPlay }) => runInPlay);
  const reason = useProof(reasonOf);
  const x = useProof(endX);
  const y = useProof(endY);
  const way = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  if (reason === null || !(isEdited || inPlay)) return null;
  const place = reasonPlace(reason, { x, y }, way, view);
  return (
    <div
      className="canvas__reason"
      role="note"
      aria-label="Where the run ends"
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(-50%, -50%)` }}
    >
      {reason}
    </div>
  );
}
