import { type KeyboardEvent, type PointerEvent, useId, useRef, useState } from 'react';

interface NumberFieldProps {
  readonly label: string;
  /** null: the selected objects have different values */
  readonly value: number | null;
  readonly min: number;
  readonly max: number;
  /** What an arrow key or a px of dragging changes it by; Shift 10 times, Alt a tenth of it. */
  readonly step?: number;
  readonly whole?: boolean;
  readonly unit?: string;
  readonly about?: string;
  readonly disabled?: boolean;
  /** @param gesture the same for all changes of one drag, so that they are one step of undo; null: a step of its own */
  readonly onChange: (value: number, gesture: string | null) => void;
  readonly onGestureEnd?: () => void;
}

/** A sum of terms is worth typing (`665+32`); anything else that is no number is refused. */
function parse(text: string): number | null {
  const clean = text.replaceAll(',', '.').replaceAll(/\s/g, '');
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?([+-](\d+\.?\d*|\.\d+))*$/i.test(clean)) return null;
  const terms = clean.match(/[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/gi) ?? [];
  return terms.reduce((sum, term) => sum + Number(term), 0);
}

const shown = (value: number | null): string => (value === null ? '' : String(Number(value.toFixed(6))));

/** A number that can be typed, stepped with the arrow keys, and dragged by its label. */
export function NumberField(props: NumberFieldProps) {
  const { label, value, min, max, step = 1, whole = false, unit, about, disabled = false, onChange, onGestureEnd } = props;
  const id = useId();
  // what is being typed, until Enter or leaving the field takes it over
  const [draft, setDraft] = useState<string | null>(null);
  const drag = useRef<{ from: number; x: number; gesture: string } | null>(null);

  const within = (next: number) => {
    const inside = Math.min(max, Math.max(min, next));
    return whole ? Math.round(inside) : Number(inside.toFixed(6));
  };
  const typed = draft === null ? value : parse(draft);
  const error =
    draft === null || draft === ''
      ? null
      : typed === null
        ? `expected a number, found "${draft}"`
        : typed < min || typed > max
          ? `expected ${min} to ${max}${unit === undefined ? '' : ` ${unit}`}`
          : null;

  const takeOver = () => {
    if (draft !== null && error === null && typed !== null && typed !== value) onChange(within(typed), null);
    setDraft(null);
  };
  const factor = (event: { shiftKey: boolean; altKey: boolean }) => (event.shiftKey ? 10 : event.altKey && !whole ? 0.1 : 1);

  const onKeyDown = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key === 'Enter') takeOver();
    else if (event.key === 'Escape') {
      if (draft !== null) event.stopPropagation();
      setDraft(null);
    } else if ((event.key === 'ArrowUp' || event.key === 'ArrowDown') && typed !== null && error === null) {
      event.preventDefault();
      const by = step * factor(event) * (event.key === 'ArrowUp' ? 1 : -1);
      setDraft(null);
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
        value={draft ?? shown(value)}
        placeholder={value === null ? 'mixed' : undefined}
        aria-invalid={error !== null}
        aria-describedby={error === null ? undefined : `${id}-error`}
        onChange={(event) => setDraft(event.target.value)}
        onKeyDown={onKeyDown}
        onBlur={() => {
          takeOver();
          onGestureEnd?.();
        }}
        onFocus={(event) => event.target.select()}
      />
      {error !== null && (
        <span id={`${id}-error`} className="number__error" role="alert">
          {error}
        </span>
      )}
    </div>
  );
}
