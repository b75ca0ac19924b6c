import { type StoreApi, useStore } from 'zustand';
import { reasonInWords } from '../../check/words/index.ts';
import { STATE_SIZE } from '../../engine/index.ts';
import { useEditor, useProof, useSession } from '../context/index.ts';
import { isWhole, type LiveProof } from '../proof/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { labelPlace } from './label-place.ts';
import { toScreen } from './view.ts';

/** greatest width in px, repeated in `canvas.css` */
const WIDEST = 232;
/** px: a line of text, and what stands around all lines */
const [LINE, AROUND] = [18, 10];
/** ticks between the points of the way that the label should not cover */
const EACH = 12;

const sizeOf = (reason: string) => {
  const width = 18 + 7 * reason.length;
  return { width: Math.min(WIDEST, width), height: AROUND + LINE * Math.ceil(width / WIDEST) };
};

const reasonOf = (proof: LiveProof): string | null => (isWhole(proof) ? reasonInWords(proof.run, proof.level.range) : null);
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
  const { states, count } = useProof(wayOf);
  const view = useStore(canvas, (state) => state.view);
  if (reason === null || !(isEdited || inPlay)) return null;
  const covered = [];
  for (let k = 0; k < count; k += EACH) {
    covered.push(toScreen(view, { x: states[k * STATE_SIZE], y: states[k * STATE_SIZE + 1] }));
  }
  const place = labelPlace(toScreen(view, { x, y }), sizeOf(reason), view, covered);
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
