import { useEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { isInView, momentPlace, type OnCanvas, reasonOf } from '../../canvas/index.ts';
import { ofLevel, useEditor, useLevel, useProof, useSession } from '../../core/context/index.ts';
import type { Rect } from './card-position.ts';
import { type Figures, type FormerRun, figuresOf } from './former.ts';
import { changedObjects } from './onion-picture.ts';
import { type Difference, rowsOf, whyUnknown } from './rows.ts';
import { followInput, locateOnPage, type Surroundings, useCardPosition } from './use-card-position.ts';
import { type OnionSession, onionOf, watchOnion } from './watch-onion.ts';
import './onion.css';
import type { LiveProof } from '../../core/proof/index.ts';
import { solverSessionOf } from '../solver/index.ts';

/** The comparison of an open level with what was before a change. */
export const onionSessionOf = ofLevel<OnionSession>((editor, level) => {
  const { session, desk } = editor;
  const { robustness } = solverSessionOf(editor, level);
  return watchOnion({ level, session, desk, robustness: robustness.store });
});

/** A sign and a word for each difference, so that colour is not the only one. */
const SIGNS: Readonly<Record<Difference, readonly [sign: string, word: string]>> = {
  better: ['▲', 'better'],
  worse: ['▼', 'worse'],
  same: ['=', 'same'],
  other: ['≠', 'different'],
  unknown: ['?', 'not known'],
};

interface CardProps {
  readonly former: FormerRun;
  /** Where objects of the level are on the page; without any, the corner of the canvas. */
  readonly whereAre: (keys: readonly string[]) => Rect;
  /** Points of the way of the shown run, px of the page. */
  readonly wayOnPage: Surroundings['way'];
}

/** The differences between the run before a change and the shown run, beside the pointer or the changed objects. */
export function OnionCard({ host, canvas }: OnCanvas) {
  const level = useLevel();
  const onion = onionSessionOf(useEditor(), level);
  const store = onionOf(level);
  const places = useMemo(() => locateOnPage(level, { host, canvas }), [level, host, canvas]);
  const former = useStore(store, (state) => state.former);
  const said = useStore(store, (state) => state.said);
  const isEdited = useSession(({ mode }) => mode === 'edit');
  useOnionEvents(onion);
  return (
    <>
      {former !== null && isEdited && <Card former={former} {...places} />}
      <p className="unseen" role="status" aria-label="Before and after">
        {said}
      </p>
    </>
  );
}

function Card({ former, whereAre, wayOnPage }: CardProps) {
  const level = useLevel();
  const { phase, slack, slackNow } = useStore(onionOf(level));
  const figures = useFigures(phase === 'held');
  const rows = rowsOf(former.figures, figures, { before: slack, now: slackNow });
  const unknown = whyUnknown(former.figures, figures);
  const card = useRef<HTMLDivElement>(null);
  const around = useMemo(
    () => ({
      objects() {
        const changed = changedObjects(former.file, level.document.file());
        return whereAre(changed.flatMap(({ key, is }) => (is === null ? [] : [key])));
      },
      way: wayOnPage,
    }),
    [former, level, whereAre, wayOnPage],
  );
  useCardPosition(card, phase, around);
  return (
    <div ref={card} className="onion" role="note" aria-label="Before and after the change">
      <p className="onion__head">before → after</p>
      <dl className="onion__rows numbers">
        {rows.map(({ label, before, after, by, difference }) => {
          const [sign, word] = SIGNS[difference];
          return (
            <div key={label} className={`onion__row onion__row--${difference}`}>
              <span className="onion__sign" aria-hidden>
                {sign}
              </span>
              <dt>{label}</dt>
              <dd>
                {before === after || difference === 'same' ? after : `${before} → ${after}`}
                {by !== '' && (
                  <>
                    , <b>{by}</b>
                  </>
                )}
                <span className="unseen">, {word}</span>
              </dd>
            </div>
          );
        })}
      </dl>
      {unknown !== null && <p className="onion__note">{unknown}</p>}
    </div>
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

/** ms between two changes of the figures during a gesture: nobody reads faster, and each change costs layout and paint. */
const PACE = 100;

/** The figures of the shown run; while something is dragged, those of a moment ago. */
function useFigures(isHeld: boolean): Figures {
  const { proof } = useLevel();
  const [figures, setFigures] = useState(() => figuresOf(proof.proof()));
  useEffect(() => {
    let timer: number | null = null;
    const show = () => {
      timer = null;
      setFigures(figuresOf(proof.proof()));
    };
    show();
    const stop = proof.store.subscribe(() => {
      if (isHeld) timer ??= window.setTimeout(show, PACE);
      else show();
    });
    return () => {
      stop();
      if (timer !== null) window.clearTimeout(timer);
    };
  }, [proof, isHeld]);
  return figures;
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
