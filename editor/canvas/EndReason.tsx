import { type StoreApi, useStore } from 'zustand';
import { reasonInWords } from '../../check/words/index.ts';
import { useEditor, useProof, useSession } from '../context/index.ts';
import { isWhole, type LiveProof } from '../proof/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { toScreen } from './view.ts';

/** px of screen from the place where the run ends */
const BESIDE = 16;
/** px of screen to the canvas's edges */
const MARGIN = 8;
/** greatest width in px, repeated in `canvas.css` */
const WIDEST = 232;
const roomOf = (reason: string): number => Math.min(WIDEST, 18 + 7 * reason.length);

const reasonOf = (proof: LiveProof): string | null => (isWhole(proof) ? reasonInWords(proof.run, proof.level.range) : null);
const endX = ({ run }: LiveProof): number => run.way.last[0];
const endY = ({ run }: LiveProof): number => run.way.last[1];

/** Why the shown run fails, beside the place where it fails. */
export function EndReason({ canvas }: { readonly canvas: StoreApi<CanvasState> }) {
  const { settings } = useEditor();
  const isEdited = useSession(({ mode }) => mode === 'edit');
  const inPlay = useStore(settings, ({ runInPlay }) => runInPlay);
  const reason = useProof(reasonOf);
  const x = useProof(endX);
  const y = useProof(endY);
  const view = useStore(canvas, (state) => state.view);
  if (reason === null || !(isEdited || inPlay)) return null;
  const end = toScreen(view, { x, y });
  const toTheLeft = end.x + BESIDE + roomOf(reason) > view.width;
  const within = (value: number, size: number) => Math.min(size - MARGIN, Math.max(MARGIN, value));
  const place = { x: within(end.x + (toTheLeft ? -BESIDE : BESIDE), view.width), y: within(end.y, view.height) };
  return (
    <div
      className="canvas__reason"
      role="note"
      aria-label="Where the run ends"
      style={{ transform: `translate(${place.x}px, ${place.y}px) translate(${toTheLeft ? '-100%' : '0'}, -50%)` }}
    >
      {reason}
    </div>
  );
}
