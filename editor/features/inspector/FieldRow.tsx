import { RotateCcw } from 'lucide-react';
import { type KeyboardEvent, memo, useId, useState } from 'react';
import { useLevel } from '../../core/context/index.ts';
import type { Recipe } from '../../core/document/index.ts';
import { Segments } from '../../core/panel/index.ts';
import { Button, NumberField } from '../../core/ui/index.ts';
import type { Field, FieldValue } from './fields.ts';

interface FieldRowProps {
  readonly field: Field;
  /** null if the selected objects differ */
  readonly value: FieldValue['value'];
  /** The file has no value, so the default applies. */
  readonly isDefault: boolean;
  /** For the label in the history: `of 3 objects`. */
  readonly whose: string;
  /**
   * Stable between renders.
   * @param value undefined removes the property, so that the default applies
   */
  readonly recipe: (key: string, value: Field['fallback']) => Recipe;
}

/** A property that can be typed, dragged or switched, with its error beside it and a button that restores the default. */
export const FieldRow = memo(function FieldRow({ field, value: shown, isDefault, whose, recipe }: FieldRowProps) {
  const { document } = useLevel();
  const refusalId = useId();
  // the refusal belongs to the value that stayed in place
  const [refused, setRefused] = useState<{ readonly why: string; readonly of: FieldValue['value'] } | null>(null);
  const refusal = refused !== null && refused.of === shown ? refused.why : null;
  const { key, label, type, fallback, ends } = field;
  const change = (value: Field['fallback'], gesture: string | null) => {
    const result = document.change(`Set ${label} ${whose}`, recipe(key, value), gesture === null ? {} : { gesture });
    setRefused(result.ok ? null : { why: `${result.refusal.message}. ${result.refusal.hint}`, of: shown });
    return result.ok;
  };
  const canReset = fallback !== undefined && !isDefault;
  return (
    <div className={isDefault ? 'row row--default' : 'row'} title={field.about}>
      {type === 'number' && (
        <NumberField
          label={label}
          value={shown as number | null}
          min={field.least}
          max={field.most}
          step={field.step}
          unit={field.unit ?? undefined}
          about={field.about}
          onChange={change}
          onGestureEnd={document.seal}
        />
      )}
      {type === 'flag' && (
        <Segments
          label={label}
          value={shown === null ? null : shown === true ? 'on' : 'off'}
          options={[
            { value: 'off', title: ends[0], about: field.about },
            { value: 'on', title: ends[1], about: field.about },
          ]}
          onChange={(next) => {
            const value = next === 'on';
            change(value === fallback ? undefined : value, null);
          }}
        />
      )}
      {type === 'text' && (
        <TextField
          field={field}
          label={label}
          value={String(shown ?? '')}
          refusalId={refusal === null ? null : refusalId}
          onChange={change}
        />
      )}
      <span className="row__end">
        {type === 'number' && <span className="row__unit">{field.unit}</span>}
        {type !== 'flag' && canReset && (
          <Button
            hint={`Reset to the default${fallback === '' ? '' : `, ${String(fallback)}`}`}
            icon={<RotateCcw size={13} />}
            className="row__reset"
            aria-label={`Reset ${label}`}
            onClick={() => change(undefined, null)}
          />
        )}
      </span>
      {refusal !== null && (
        <span id={refusalId} className="row__refusal" role="alert">
          {refusal}
        </span>
      )}
    </div>
  );
});

interface TextFieldProps {
  readonly field: Field;
  readonly label: string;
  readonly value: string;
  /** The id of the element that says why the text was refused; null if it was not. */
  readonly refusalId: string | null;
  /** @returns whether the text was accepted */
  readonly onChange: (value: string | undefined, gesture: string) => boolean;
}

/** A text field. A refused text stays so that it can be corrected; Esc restores the value of the level. */
function TextField({ field, label, value, refusalId, onChange }: TextFieldProps) {
  const { document } = useLevel();
  const id = useId();
  const [kept, setKept] = useState<{ readonly text: string; readonly of: string } | null>(null);
  const draft = kept !== null && kept.of === value ? kept.text : null;
  const shared = {
    id,
    className: 'field',
    value: draft ?? value,
    maxLength: field.most,
    'aria-invalid': refusalId !== null,
    'aria-describedby': refusalId ?? undefined,
    onChange: (event: { target: { value: string } }) => {
      const text = event.target.value;
      const isTaken = onChange(text === field.fallback ? undefined : text, `type ${id}`);
      setKept(isTaken ? null : { text, of: value });
    },
    onKeyDown: (event: KeyboardEvent) => {
      if (event.key !== 'Escape' || draft === null) return;
      event.stopPropagation();
      // the level's own value is always accepted, which clears the refusal
      onChange(value, `type ${id}`);
      setKept(null);
    },
    onBlur: document.seal,
  };
  return (
    <div className="text-row">
      <label htmlFor={id}>{label}</label>
      {field.most > 200 ? <textarea rows={3} {...shared} /> : <input type="text" {...shared} />}
    </div>
  );
}
