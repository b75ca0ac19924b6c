import { X } from 'lucide-react';
import { useState } from 'react';
import { plural } from '../../core/figures/index.ts';
import { Button } from '../../core/ui/index.ts';
import type { Chapter } from './pack-model.ts';

interface ChapterHeadProps {
  readonly chapter: Chapter;
  readonly canEdit: boolean;
  readonly isDrop: boolean;
  readonly onRename: (place: number, name: string) => void;
  readonly onRemove: (place: number) => void;
}

/** The heading of a chapter, which can be edited in place. */
export function ChapterHead({ chapter, canEdit, isDrop, onRename, onRemove }: ChapterHeadProps) {
  const { name, place, isUnlisted, cards } = chapter;
  const count = <span className="pack__count">{plural(cards.length, 'level')}</span>;
  if (name === null || place === null) {
    if (!isUnlisted) return null;
    return (
      <header className="pack__chapter">
        <h3>Not listed</h3>
        {count}
        <span className="pack__note">Players do not get these levels. Move one up to list it.</span>
      </header>
    );
  }
  return (
    <header className={`pack__chapter${isDrop ? ' pack__chapter--drop' : ''}`} data-place={place} data-chapter>
      {canEdit ? (
        <>
          <h3>
            <NameField
              key={name}
              label="Chapter"
              name={name}
              className="pack__chapter-name"
              fits
              onDone={(next) => onRename(place, next)}
            />
          </h3>
          {count}
          <Button hint={`Remove the heading "${name}"; its levels stay`} icon={<X size={14} />} onClick={() => onRemove(place)} />
        </>
      ) : (
        <>
          <h3>{name}</h3>
          {count}
        </>
      )}
    </header>
  );
}

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
