import { type PointerEvent, type RefObject, useRef } from 'react';
import type { Hold } from '../../schema/index.ts';
import { useEditor, useLevel } from '../core/context/index.ts';
import { addHold, type Gesture, moveHold, type Recipe, splitHold, stretchHold } from '../core/document/index.ts';
import { type Grip, gripAt } from './holds.ts';
import { type Scale, toTick } from './scale.ts';

const NONE: readonly number[] = [];
const NO_HOLD: readonly [number, number] = [0, 0];

interface Drag {
  readonly part: Grip['part'] | 'new';
  readonly index: number;
  /** The hold when the drag began: each move starts again from there. */
  readonly hold: Hold;
  readonly x: number;
  readonly tick: number;
  readonly gesture: Gesture;
  moved: boolean;
}

const LABELS = { body: 'Move hold', press: 'Move press', release: 'Move release', new: 'Add hold' } as const;

/** px that a press may move and still be a click */
const SLOP = 3;

interface HoldDragParts {
  readonly lane: RefObject<HTMLDivElement | null>;
  readonly run: string;
  readonly holds: readonly Hold[];
  readonly scale: Scale;
  /** Indices of the selected holds. */
  readonly selected: readonly number[];
  readonly onDragging: (isDragging: boolean) => void;
}

/** Draws, moves, stretches and splits holds with the pointer. @returns the listeners of the lane, and how to cancel a drag */
export function useHoldDrag({ lane, run, holds, scale, selected, onDragging }: HoldDragParts) {
  const { session, notices } = useEditor();
  const { document, selection } = useLevel();
  const drag = useRef<Drag | null>(null);
  const xOf = (event: { clientX: number }) => event.clientX - (lane.current?.getBoundingClientRect().left ?? 0);

  const onPointerDown = (event: PointerEvent<HTMLElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    onDragging(true);
    const x = xOf(event);
    // The position decides: the touch targets of neighbouring holds overlap.
    const grip = gripAt(holds, scale, x, event.pointerType === 'touch' ? 'coarse' : 'fine');
    const { part, index } = grip ?? ({ part: 'new', index: -1 } as const);
    const [hold, gesture] = [holds[index] ?? NO_HOLD, document.begin(LABELS[part])];
    drag.current = { part, index, hold, x, tick: toTick(scale, x), gesture, moved: false };
    if (grip === null) return;
    const others = event.shiftKey ? selected : NONE;
    selection.selectHolds(run, others.includes(index) ? others.filter((other) => other !== index) : [...others, index]);
  };
  const onPointerMove = (event: PointerEvent<HTMLElement>) => {
    const now = drag.current;
    if (now === null) return;
    const x = xOf(event);
    if (!now.moved && Math.abs(x - now.x) < SLOP) return;
    now.moved = true;
    const result = now.gesture.set(draggedBy(run, now, Math.round((x - now.x) / scale.zoom), event.altKey));
    if (!result.ok) notices.show('warning', result.refusal.message, { topic: 'refused' });
  };
  const onPointerUp = () => {
    const now = drag.current;
    drag.current = null;
    onDragging(false);
    if (now === null) return;
    if (now.moved) {
      now.gesture.commit();
      return;
    }
    now.gesture.cancel();
    if (now.part !== 'new') return;
    selection.clear();
    session.setState({ tick: Math.max(0, Math.round(now.tick)) });
  };
  const cancel = () => {
    drag.current?.gesture.cancel();
    drag.current = null;
    onDragging(false);
  };
  const onDoubleClick = (event: { clientX: number }) => {
    const tick = toTick(scale, xOf(event));
    const index = holds.findIndex(([press, release]) => press < tick && tick < release);
    if (index >= 0) document.change('Split hold', splitHold(run, index, tick));
  };

  return {
    listeners: { onPointerDown, onPointerMove, onPointerUp, onPointerCancel: cancel, onDoubleClick },
    isDragging: () => drag.current !== null,
    cancel,
  };
}

/** The edit that a drag makes. @param by ticks @param ripple whether everything later moves as well */
function draggedBy(run: string, { part, index, hold, tick }: Drag, by: number, ripple: boolean): Recipe {
  if (part === 'new') return addHold(run, Math.max(0, Math.floor(tick)), Math.max(0, Math.ceil(tick + by)));
  if (part === 'body') return moveHold(run, index, by, { ripple });
  return stretchHold(run, index, part, (part === 'press' ? hold[0] : hold[1]) + by, { ripple });
}
