import { type RefObject, useCallback, useEffect, useLayoutEffect, useRef } from 'react';
import { cardPlace, type Rect, type Side } from './card-position.ts';
import { type Input, lastInput } from './last-input.ts';
import type { Comparison } from './onion-store.ts';

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
export function useCardPlace(card: RefObject<HTMLElement | null>, phase: Comparison['phase'], around: Surroundings): void {
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
    const { x, y, ...place } = cardPlace(anchor.current, size.current, page, around.way, side.current);
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
