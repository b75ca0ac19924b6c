import { useEffect } from 'react';
import { useStore } from 'zustand';
import { isInView, momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { ofLevel, useEditor, useLevel, useProof, useSession } from '../../core/context/index.ts';
import { laterPart } from '../../core/panel/index.ts';
import { followInput, type OnionSession, onionOf, watchOnion } from './watch-onion.ts';
import './onion.css';
import type { LiveProof } from '../../core/proof/index.ts';
import { solverSessionOf } from '../solver/index.ts';

const Differences = laterPart(() => import('./Differences.tsx').then((there) => there.Differences));

/** The comparison of an open level with what was before a change. */
export const onionSessionOf = ofLevel<OnionSession>((editor, level) => {
  const { session, desk } = editor;
  const { robustness } = solverSessionOf(editor, level);
  return watchOnion({ level, session, desk, robustness: robustness.store });
});

/** The differences between the run before a change and the shown run, beside the pointer or the changed objects. */
export function OnionCard({ host, canvas }: OnCanvas) {
  const level = useLevel();
  const onion = onionSessionOf(useEditor(), level);
  const store = onionOf(level);
  const former = useStore(store, (state) => state.former);
  const said = useStore(store, (state) => state.said);
  const isEdited = useSession(({ mode }) => mode === 'edit');
  useOnionEvents(onion);
  return (
    <>
      {former !== null && isEdited && <Differences {...{ former, host, canvas }} />}
      <p className="unseen" role="status" aria-label="Before and after">
        {said}
      </p>
    </>
  );
}

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

const MODIFIERS: readonly string[] = ['Shift', 'Alt', 'Control', 'Meta'];

/** Tells the session what the user does anywhere on the page. */
function useOnionEvents(onion: OnionSession): void {
  useEffect(() => {
    const stopping = new AbortController();
    followInput(stopping.signal);
    // before other listeners, as some of them stop the event
    const options = { capture: true, signal: stopping.signal };
    const onKey = ({ key }: KeyboardEvent) => {
      if (!MODIFIERS.includes(key)) onion.dismiss();
    };
    // after other listeners, which end the gesture
    const onUp = () => void setTimeout(onion.released);
    window.addEventListener('pointerdown', onion.dismiss, options);
    window.addEventListener('keydown', onKey, options);
    for (const type of ['pointerup', 'pointercancel', 'keyup', 'blur'] as const) window.addEventListener(type, onUp, options);
    return () => stopping.abort();
  }, [onion]);
}
