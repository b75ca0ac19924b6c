import { X } from 'lucide-react';
import { plural } from '../../core/figures/index.ts';
import { Button } from '../../core/ui/index.ts';
import { NameField } from './NameField.tsx';
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
