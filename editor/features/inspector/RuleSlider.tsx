import { type KeyboardEvent, type PointerEvent, useEffect, useId, useRef } from 'react';
import type { GameRule } from '../../../schema/index.ts';
import { useLevel } from '../../core/context/index.ts';
import type { Gesture, Recipe } from '../../core/document/index.ts';
import { positionOf, SLIDER_END, stepOf, valueAt, within } from './rule-scale.ts';

/** how many steps a key moves the slider */
const KEYS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
};

interface RuleSliderProps {
  readonly rule: GameRule;
  readonly label: string;
  readonly value: number;
  /** The label of the step in the history. */
  readonly step: string;
  /** Ids of the elements that describe it. */
  readonly describedBy: string;
  readonly recipe: (value: number) => Recipe;
}

/** The slider of a rule: the level follows while it is dragged, a drag is one step of the history, and Esc undoes it. */
export function RuleSlider({ rule, label, value, step, describedBy, recipe }: RuleSliderProps) {
  const { document } = useLevel();
  const id = useId();
  const drag = useRef<{ readonly gesture: Gesture; readonly stop: () => void } | null>(null);
  const end = (how: 'commit' | 'cancel') => {
    drag.current?.gesture[how]();
    drag.current?.stop();
    drag.current = null;
  };
  // A drag in progress when the slider is unmounted is kept.
  useEffect(
    () => () => {
      drag.current?.gesture.commit();
      drag.current?.stop();
    },
    [],
  );

  const onPointerDown = ({ button, pointerId, currentTarget: { ownerDocument } }: PointerEvent) => {
    if (button !== 0) return;
    end('commit');
    // The button may be released anywhere.
    const abort = new AbortController();
    const { signal } = abort;
    const listen = (type: 'pointerup' | 'pointercancel', how: 'commit' | 'cancel') =>
      ownerDocument.addEventListener(type, (event) => event.pointerId === pointerId && end(how), { signal, capture: true });
    listen('pointerup', 'commit');
    // the touch turned out to scroll the panel
    listen('pointercancel', 'cancel');
    drag.current = { gesture: document.begin(step), stop: () => abort.abort() };
  };
  const change = (next: number) => void document.change(step, recipe(next), { gesture: `slide ${id}` });
  const onKeyDown = (event: KeyboardEvent) => {
    if (event.key === 'Escape' && drag.current !== null) {
      event.stopPropagation();
      // The pointer still holds the slider: the rest of this drag is ignored.
      drag.current.gesture.cancel();
      return;
    }
    const by = KEYS[event.key];
    const edge = event.key === 'Home' ? rule.least : event.key === 'End' ? rule.most : null;
    if ((by === undefined && edge === null) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    change(edge ?? within(rule, value + by * stepOf(rule) * (event.shiftKey ? 10 : 1)));
  };
  return (
    <input
      type="range"
      className="rule__slider"
      aria-label={label}
      aria-valuetext={`${value} ${rule.unit}`}
      aria-describedby={describedBy}
      min={0}
      max={SLIDER_END}
      step="any"
      value={positionOf(rule, value)}
      onPointerDown={onPointerDown}
      onKeyDown={onKeyDown}
      onChange={(event) => {
        const next = valueAt(rule, Number(event.target.value));
        if (drag.current === null) change(next);
        else drag.current.gesture.set(recipe(next));
      }}
      onBlur={document.seal}
    />
  );
}
