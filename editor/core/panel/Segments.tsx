import { type ReactNode, useId } from 'react';

interface SegmentsProps<T extends string> {
  readonly label: string;
  /** null: none is chosen, as the selected objects differ */
  readonly value: T | null;
  readonly options: readonly { readonly value: T; readonly title: string; readonly about?: string; readonly icon?: ReactNode }[];
  readonly disabled?: boolean;
  readonly onChange: (value: T) => void;
}

/** A choice of one among a few options, all visible. */
export function Segments<T extends string>({ label, value, options, disabled = false, onChange }: SegmentsProps<T>) {
  const name = useId();
  return (
    <fieldset className="segments" disabled={disabled}>
      <legend className="segments__label">{label}</legend>
      <div className="segments__row">
        {options.map((option) => (
          <label key={option.value} className="segments__one" title={option.about}>
            <input
              type="radio"
              name={name}
              value={option.value}
              checked={option.value === value}
              onChange={() => onChange(option.value)}
            />
            <span>
              {option.icon}
              {option.title}
            </span>
          </label>
        ))}
      </div>
    </fieldset>
  );
}
