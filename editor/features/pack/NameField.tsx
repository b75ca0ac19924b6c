import { useState } from 'react';

interface NameFieldProps {
  readonly label: string;
  readonly name: string;
  readonly className: string;
  /** Whether the field is as wide as what is typed. */
  readonly fits?: boolean;
  readonly onDone: (name: string) => void;
}

/** A name that is edited in place, keyed by the name: Enter or leaving the field keeps it, Esc takes it back, and an empty one is not kept. */
export function NameField({ label, name, className, fits = false, onDone }: NameFieldProps) {
  const [text, setText] = useState(name);
  const done = () => {
    const next = text.trim();
    if (next === '') setText(name);
    else if (next !== name) onDone(next);
  };
  return (
    <input
      className={`field ${className}`}
      aria-label={label}
      value={text}
      maxLength={120}
      size={fits ? Math.max(12, text.length) : undefined}
      onChange={(event) => setText(event.target.value)}
      onBlur={done}
      onKeyDown={(event) => {
        if (event.key === 'Enter') event.currentTarget.blur();
        if (event.key === 'Escape' && text !== name) {
          event.stopPropagation();
          setText(name);
        }
      }}
    />
  );
}
