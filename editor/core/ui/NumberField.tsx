import { type KeyboardEvent, type PointerEvent, useId, useRef, useState } from 'react';

interface NumberFieldProps {
  readonly label: string;
  /** null: the selected objects differ */
  readonly value: number | null;
  readonly min: number;
  readonly max: number;
  /** The change per arrow key or px of a drag; 10 times as much with Shift, a tenth with Alt. */
  readonly step?: number;
  readonly whole?: boolean;
  readonly unit?: string;
  readonly about?: string;
  readonly disabled?: boolean;
  /** @param gesture equal for all changes of one drag, which then form one undo step; null: a step of its own */
  readonly onChange: (value: number, gesture: string | null) => void;
  readonly onGestureEnd?: () => void;
}

/** Parses a number or a sum of numbers (`665+32`); null for anything else. */
function parse(text: string): number | null {
  const clean = text.replaceAll(',', '.').replaceAll(/\s/g, '');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?([+-](\d+\.?\d*|\.\d+))*$/i.test(clean)) return null;
  const terms = clean.match(/[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/gi) ?? [];
  return terms.reduce((sum, term) => sum + Number(term), 0);
}

const shown = (value: number | null): string => (value === null ? '' : String(Number(value.toFixed(6))));

/** Typed text that is not applied. */
interface Draft {
  readonly text: string;
  /** The value that it should replace: if the value changes, the draft is discarded. */
  readonly of: number | null;
  /** Whether Enter or blur tried to apply the text, and it was refused. */
  readonly isRefused: boolean;
}

/**
 * A number that can be typed, stepped with the arrow keys, and dragged by its label. Refused text stays so that it can be
 * corrected, with the reason beside it.
 */
export function NumberField(props: NumberFieldProps) {
  const { label, value, min, max, step = 1, whole = false, unit, about, disabled = false, onChange, onGestureEnd } = props;
  const id = useId();
  // typed text, until Enter or blur applies it
  const [kept, setKept] = useState<Draft | null>(null);
  const draft = kept !== null && kept.of === value ? kept : null;
  const drag = useRef<{ from: number; x: number; gesture: string } | null>(null);

  const within = (next: number) => {
    const inside = Math.min(max, Math.max(min, next));
    return whole ? Math.round(inside) : Number(inside.toFixed(6));
  };
  const isEmpty = draft !== null && draft.text.trim() === '';
  const typed = draft === null ? value : parse(draft.text);
  const problem = (): string | null => {
    if (draft === null) return null;
    // An empty field is the start of typing a new number; a field for differing values is empty anyway.
    if (isEmpty) return draft.isRefused && value !== null ? 'expected a number, found nothing' : null;
    if (typed === null) return `expected a number, found "${draft.text}"`;
    if (typed < min || typed > max) return `expected ${min} to ${max}${unit === undefined ? '' : ` ${unit}`}, found ${typed}`;
    return whole && !Number.isInteger(typed) ? `expected a whole number, found ${typed}` : null;
  };
  const error = problem();

  const takeOver = () => {
    if (draft === null) return;
    if (error !== null || (isEmpty && value !== null)) {
      setKept({ ...draft, isRefused: true });
      return;
    }
    if (typed !== null && typed !== value) onChange(within(typed), null);
    setKept(null);
  };
  const factor = (event: { shiftKey: boolean; altKey: boolean }) => (event.shiftKey ? 10 : event.altKey && !whole ? 0.1 : 1);

  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key === 'Enter') takeOver();
    else if (event.key === 'Escape') {
      if (draft !== null) event.stopPropagation();
      setKept(null);
    } else if ((event.key === 'ArrowUp' || event.key === 'ArrowDown') && typed !== null && error === null) {
      event.preventDefault();
      const by = step * factor(event) * (event.key === 'ArrowUp' ? 1 : -1);
      setKept(null);
      onChange(within(typed + by), `step ${id}`);
    }
  };
  const onPointerDown = (event: PointerEvent<HTMLLabelElement>) => {
    if (disabled || value === null || event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    drag.current = { from: value, x: event.clientX, gesture: `drag ${id} ${event.timeStamp}` };
  };
  const onPointerMove = (event: PointerEvent<HTMLLabelElement>) => {
    if (drag.current === null) return;
    const next = within(drag.current.from + (event.clientX - drag.current.x) * step * factor(event));
    if (next !== value) onChange(next, drag.current.gesture);
  };
  const onPointerEnd = () => {
    if (drag.current !== null) onGestureEnd?.();
    drag.current = null;
  };

  return (
    <div className="number">
      <label
        className="number__label"
        htmlFor={id}
        title={about}
        onPointerDown={onPointerDown}
        onPointerMove={onPointerMove}
        onPointerUp={onPointerEnd}
        onPointerCancel={onPointerEnd}
      >
        {label}
      </label>
      <input
        id={id}
        className="field numbers"
        inputMode="decimal"
        autoComplete="off"
        disabled={disabled}
        value={draft?.text ?? shown(value)}
        placeholder={value === null ? 'mixed' : undefined}
        aria-invalid={error !== null}
        aria-describedby={error === null ? undefined : `${id}-error`}
        onChange={(event) => setKept({ text: event.target.value, of: value, isRefused: false })}
        onKeyDown={onKeyDown}
        onBlur={() => {
          takeOver();
          onGestureEnd?.();
        }}
        onFocus={(event) => event.target.select()}
      />
      {error !== null && (
        <span id={`${id}-error`} className="number__error" role="alert">
          {error}. {value === null ? 'Nothing was changed' : `It is still ${shown(value)}`}: type another number, or press Esc to
          restore it.
        </span>
      )}
    </div>
  );
}
