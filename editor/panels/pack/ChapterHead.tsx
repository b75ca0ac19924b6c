import { X } from 'lucide-react';
import { useEffect, useState } from 'react';
import { Button } from '../../ui/index.ts';
import { plural } from '../figures/index.ts';
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
          <ChapterName key={name} name={name} onDone={(next) => onRename(place, next)} />
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

/** The name of a chapter as a field: Enter or leaving it keeps the name, Esc takes it back. */
function ChapterName({ name, onDone }: { readonly name: string; readonly onDone: (name: string) => void }) {
  const [text, setText] = useState(name);
  useEffect(() => setText(name), [name]);
  const done = () => {
    const next = text.trim();
    if (next === '') setText(name);
    else if (next !== name) onDone(next);
  };
  return (
    <h3>
      <input
        className="field pack__chapter-name"
        aria-label="Chapter"
        value={text}
        maxLength={120}
        size={Math.max(12, text.length)}
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
    </h3>
  );
}
