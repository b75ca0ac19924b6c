import { type RefObject, useCallback, useEffect, useLayoutEffect, useMemo, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { extentOf, type OnCanvas, pointsOfWay, toScreen } from '../../canvas/index.ts';
import { type OpenLevel, useLevel } from '../../core/context/index.ts';
import { cardPosition, type Rect, type Side } from './card-position.ts';
import { type Figures, type FormerRun, figuresOf } from './former.ts';
import { changedObjects } from './onion-picture.ts';
import { type Difference, rowsOf, whyUnknown } from './rows.ts';
import { type Comparison, type Input, lastInput, onionOf } from './watch-onion.ts';

/** px that the card keeps from what it stands beside: a finger and the hand behind it cover more than a pointer */
const CLEAR = { keys: 20, mouse: 20, touch: 56 } as const;
/** px between the card and an object under the pointer */
const GAP = 8;

const widened = ({ left, top, right, bottom }: Rect, by: number): Rect => ({
  left: left - by,
  top: top - by,
  right: right + by,
  bottom: bottom + by,
});

/** A panel on the canvas whose figures make the change: all of it stays free. */
const openPanel = (): Rect | null => document.querySelector('[data-keeps-clear]')?.getBoundingClientRect() ?? null;

/** What has the focus, unless that is the whole canvas or the page. */
function focused(): Rect | null {
  const { activeElement, body } = document;
  return activeElement === null || activeElement === body || activeElement.matches('.canvas')
    ? null
    : activeElement.getBoundingClientRect();
}

/** What a card stands beside on the page, px of the page. */
export interface Surroundings {
  /** Where the changed objects are. */
  readonly objects: () => Rect;
  /** Points of the way of the run. */
  readonly way: () => readonly { readonly x: number; readonly y: number }[];
}

/** px by which a large object under the pointer keeps the card away at most */
const MOST_CLEAR = 140;

/** How much is kept free around the pointer: what it has hold of, as far as that is not too large. */
function marginsOf({ objects }: Surroundings, input: Exclude<Input, { by: 'keys' }>): Rect {
  const { x, y, by } = input;
  const rect = objects();
  const isHeld = x > rect.left && x < rect.right && y > rect.top && y < rect.bottom;
  const margin = (away: number) => (isHeld ? Math.min(MOST_CLEAR, Math.max(CLEAR[by], away + GAP)) : CLEAR[by]);
  return {
    left: margin(x - rect.left),
    top: margin(y - rect.top),
    right: margin(rect.right - x),
    bottom: margin(rect.bottom - y),
  };
}

/** Keeps a card beside the pointer, or beside the changed objects, for as long as the change is in progress. */
export function useCardPosition(card: RefObject<HTMLElement | null>, phase: Comparison['phase'], around: Surroundings): void {
  const anchor = useRef<Rect | null>(null);
  const margins = useRef<Rect | null>(null);
  const size = useRef({ width: 0, height: 0 });
  const side = useRef<Side | null>(null);
  /** What the card must not cover. What is under the pointer is looked up once: it moves along. */
  const anchorNow = useCallback((): Rect => {
    const input = lastInput();
    const panel = openPanel();
    if (panel !== null) return widened(panel, GAP);
    if (input.by === 'keys') return widened(focused() ?? around.objects(), CLEAR.keys);
    margins.current ??= marginsOf(around, input);
    const { left, top, right, bottom } = margins.current;
    return { left: input.x - left, top: input.y - top, right: input.x + right, bottom: input.y + bottom };
  }, [around]);
  const put = useCallback(() => {
    if (card.current === null || anchor.current === null) return;
    const page = { width: window.innerWidth, height: window.innerHeight };
    const { x, y, ...place } = cardPosition(anchor.current, size.current, page, around.way, side.current);
    side.current = place.side;
    card.current.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
  }, [card, around]);
  useLayoutEffect(() => {
    if (card.current !== null) size.current = { width: card.current.offsetWidth, height: card.current.offsetHeight };
  }, [card]);
  // keys move the objects; where the pointer is, its own listener knows
  useLayoutEffect(() => {
    if (anchor.current !== null && (phase === 'ended' || lastInput().by !== 'keys')) return;
    anchor.current = anchorNow();
    put();
  });
  useEffect(() => {
    const stopping = new AbortController();
    const follow = () => {
      if (lastInput().by === 'keys') return;
      anchor.current = anchorNow();
      put();
    };
    if (phase === 'held')
      window.addEventListener('pointermove', follow, { capture: true, passive: true, signal: stopping.signal });
    const observer = new ResizeObserver(([entry]) => {
      const box = entry?.borderBoxSize[0];
      if (box !== undefined) size.current = { width: box.inlineSize, height: box.blockSize };
      put();
    });
    if (card.current !== null) observer.observe(card.current);
    return () => {
      stopping.abort();
      observer.disconnect();
    };
  }, [card, phase, anchorNow, put]);
}

// where the canvas shows things on the page

/** px below the upper edge of the canvas, where the tools stand */
const TOOLS = 56;

/** Finds on the page what the canvas shows; px of the page. @param host the element of the canvas */
export function locateOnPage(level: OpenLevel, { host, canvas }: OnCanvas) {
  const canvasBox = () => host.current?.getBoundingClientRect() ?? { left: 0, top: 0, right: 0, bottom: 0 };
  return {
    /** The box around objects; the upper left corner of the canvas if there are none or they are not in view. */
    whereAre(keys: readonly string[]) {
      const { left, top, right, bottom } = canvasBox();
      const corner = { left, top, right: left, bottom: top + TOOLS };
      const box = keys.length === 0 ? null : extentOf(level.document.file(), level.proof.proof().scene.box, keys);
      if (box === null) return corner;
      const { view } = canvas.getState();
      const from = toScreen(view, { x: box.left, y: box.top });
      const to = toScreen(view, { x: box.right, y: box.bottom });
      const seen = {
        left: left + Math.max(0, from.x),
        top: top + Math.max(0, from.y),
        right: Math.min(right, left + to.x),
        bottom: Math.min(bottom, top + to.y),
      };
      return seen.left <= seen.right && seen.top <= seen.bottom ? seen : corner;
    },
    /** Points of the way of the shown run. */
    wayOnPage() {
      const { left, top } = canvasBox();
      return pointsOfWay(level.proof.proof().run.way, canvas.getState().view).map(({ x, y }) => ({ x: left + x, y: top + y }));
    },
  };
}

/** A sign and a word for each difference, so that colour is not the only one. */
const SIGNS: Readonly<Record<Difference, readonly [sign: string, word: string]>> = {
  better: ['▲', 'better'],
  worse: ['▼', 'worse'],
  same: ['=', 'same'],
  other: ['≠', 'different'],
  unknown: ['?', 'not known'],
};

interface DifferencesProps extends OnCanvas {
  readonly former: FormerRun;
}

/** The differences between the run before a change and the shown run. */
export function Differences({ former, host, canvas }: DifferencesProps) {
  const level = useLevel();
  const { whereAre, wayOnPage } = useMemo(() => locateOnPage(level, { host, canvas }), [level, host, canvas]);
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
