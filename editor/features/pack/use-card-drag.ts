import { type PointerEvent as ReactPointerEvent, useEffect, useRef, useState } from 'react';

/** px that a mouse moves before a press becomes a drag */
const THRESHOLD = 5;
/** px from the edge of the view within which it scrolls, and how far it does each frame */
const EDGE = 56;
const SCROLL = 12;

/** Where dragged cards would be dropped: before this place among all entries. */
export interface CardDrop {
  /** The place of the card or heading at which the mark is shown. */
  readonly at: number;
  readonly side: 'before' | 'after';
  readonly before: number;
}

interface DragOptions {
  readonly canMove: boolean;
  /** Called when a drag begins. @returns the keys of the cards that are dragged */
  readonly onTake: (key: string) => ReadonlySet<string>;
  readonly onDrop: (before: number) => void;
}

/** The drop that a point of the screen stands for; null if it is on no card and no heading. */
function dropAt(x: number, y: number): CardDrop | null {
  const element = document.elementFromPoint(x, y)?.closest<HTMLElement>('.pack [data-place]');
  if (element == null) return null;
  const at = Number(element.dataset.place);
  if (element.dataset.chapter !== undefined) return { at, side: 'after', before: at + 1 };
  const { left, top, width, height } = element.getBoundingClientRect();
  const list = element.parentElement?.getBoundingClientRect();
  // cards below each other are dropped above or below, cards beside each other before or after
  const isColumn = list !== undefined && list.width < 1.5 * width;
  const isAfter = isColumn ? y > top + height / 2 : x > left + width / 2;
  return { at, side: isAfter ? 'after' : 'before', before: isAfter ? at + 1 : at };
}

/**
 * Lets cards be dragged to another place: by a mouse or a pen anywhere on a card, by a finger at its grip, so that a finger on a card
 * still scrolls. Esc gives the drag up.
 */
export function useCardDrag({ canMove, onTake, onDrop }: DragOptions) {
  const [held, setHeld] = useState<ReadonlySet<string> | null>(null);
  const [drop, setDrop] = useState<CardDrop | null>(null);
  const drag = useRef<{ key: string; id: number; x: number; y: number; isOn: boolean } | null>(null);
  const point = useRef({ x: 0, y: 0 });
  const ended = useRef(false);

  const end = () => {
    drag.current = null;
    setHeld(null);
    setDrop(null);
  };

  // the view scrolls while a card is held near its edge, also while the pointer rests
  useEffect(() => {
    if (held === null) return;
    let frame = 0;
    const scroll = () => {
      const view = document.querySelector('.pack__scroll');
      const box = view?.getBoundingClientRect();
      if (view != null && box !== undefined) {
        const { x, y } = point.current;
        const by = y < box.top + EDGE ? -SCROLL : y > box.bottom - EDGE ? SCROLL : 0;
        const before = view.scrollTop;
        if (by !== 0) view.scrollTop += by;
        if (view.scrollTop !== before) setDrop((now) => dropAt(x, y) ?? now);
      }
      frame = requestAnimationFrame(scroll);
    };
    frame = requestAnimationFrame(scroll);
    const onKey = (event: KeyboardEvent) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      ended.current = true;
      drag.current = null;
      setHeld(null);
      setDrop(null);
    };
    window.addEventListener('keydown', onKey, true);
    return () => {
      cancelAnimationFrame(frame);
      window.removeEventListener('keydown', onKey, true);
    };
  }, [held]);

  const listeners = {
    onPointerDown(event: ReactPointerEvent<HTMLElement>) {
      ended.current = false;
      if (!canMove || event.button !== 0 || !(event.target instanceof Element)) return;
      const card = event.target.closest<HTMLElement>('[data-key]');
      if (card === null || (event.pointerType === 'touch' && event.target.closest('[data-grip]') === null)) return;
      drag.current = { key: card.dataset.key ?? '', id: event.pointerId, x: event.clientX, y: event.clientY, isOn: false };
    },
    onPointerMove(event: ReactPointerEvent<HTMLElement>) {
      const now = drag.current;
      if (now === null || event.pointerId !== now.id) return;
      const { clientX: x, clientY: y } = event;
      point.current = { x, y };
      if (!now.isOn) {
        if (Math.abs(x - now.x) + Math.abs(y - now.y) < THRESHOLD) return;
        now.isOn = true;
        event.currentTarget.setPointerCapture(now.id);
        setHeld(onTake(now.key));
      }
      const next = dropAt(x, y);
      setDrop((before) => (next === null || (before?.before === next.before && before.side === next.side) ? before : next));
    },
    onPointerUp(event: ReactPointerEvent<HTMLElement>) {
      const now = drag.current;
      if (now === null || event.pointerId !== now.id) return;
      if (now.isOn) {
        ended.current = true;
        const at = dropAt(event.clientX, event.clientY) ?? drop;
        if (at !== null) onDrop(at.before);
      }
      end();
    },
    onPointerCancel: end,
  };
  /** Whether the click that follows belongs to a drag that has just ended. */
  const wasDrag = (): boolean => {
    const was = ended.current;
    ended.current = false;
    return was;
  };
  return { held, drop, listeners, wasDrag };
}
