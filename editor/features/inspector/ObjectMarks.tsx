import { EyeOff, Lock, LockOpen } from 'lucide-react';
import { useCallback } from 'react';
import { useDocument, useEditor, useLevel, useSelectedKeys } from '../../core/context/index.ts';
import { type FoundObject, LONGEST_NAME, MARK_KEYS, marksOf, setMark } from '../../core/document/index.ts';
import { areAll } from '../../core/order/index.ts';
import { Button } from '../../core/ui/index.ts';
import { FieldRow } from './FieldRow.tsx';
import type { Field } from './fields.ts';

const NAME: Field = {
  key: MARK_KEYS.name,
  label: 'name',
  type: 'text',
  least: 0,
  most: LONGEST_NAME,
  step: 1,
  about: 'A name for people who edit the level; nothing else looks at it.',
  unit: null,
  fallback: '',
  ends: ['off', 'on'],
};

/** The name of an object. */
export function NameRow({ found, whose }: { readonly found: FoundObject; readonly whose: string }) {
  const { key } = found;
  const { name } = marksOf(found);
  const recipe = useCallback(
    (_: string, value: Field['fallback']) => setMark([key], 'name', typeof value === 'string' ? value : null),
    [key],
  );
  return <FieldRow field={NAME} value={name ?? ''} isDefault={name === null} whose={whose} recipe={recipe} />;
}

/** Locks or unlocks the selection. */
export function MarkButtons() {
  const { commands } = useEditor();
  const level = useLevel();
  const keys = useSelectedKeys();
  const isLocked = useDocument(() => areAll(level, keys, 'isLocked'));
  return (
    <Button
      hint="Lock"
      icon={isLocked ? <Lock size={14} /> : <LockOpen size={14} />}
      pressed={isLocked}
      onClick={() => commands.run('object.lock')}
    />
  );
}

/** How many of the selected objects have a mark: `2 of 3 are`. */
const countInWords = (count: number, all: number): string =>
  all === 1 ? 'It is' : count === all ? 'All are' : count === 1 ? `1 of ${all} is` : `${count} of ${all} are`;

/** Says what is locked or hidden, and offers the way back. */
export function MarkNotes({ objects }: { readonly objects: readonly FoundObject[] }) {
  const { commands } = useEditor();
  const marks = objects.map(marksOf);
  const locked = marks.filter(({ isLocked }) => isLocked).length;
  const hidden = marks.filter(({ isHidden }) => isHidden).length;
  const all = objects.length;
  return (
    <>
      {locked > 0 && (
        <p className="part__note inspector__mark">
          <Lock size={14} aria-hidden />
          <span>{`${countInWords(locked, all)} locked: unlock ${locked === 1 ? 'it' : 'them'} to make changes.`}</span>
          {locked === all && (
            <Button hint="Unlock the selection" look="outlined" onClick={() => commands.run('object.lock')}>
              Unlock
            </Button>
          )}
        </p>
      )}
      {hidden > 0 && (
        <p className="part__note inspector__mark">
          <EyeOff size={14} aria-hidden />
          <span>{`${countInWords(hidden, all)} hidden: the run still meets ${hidden === 1 ? 'it' : 'them'}.`}</span>
          {hidden === all && (
            <Button hint="Show the selection" look="outlined" onClick={() => commands.run('object.hide')}>
              Show
            </Button>
          )}
        </p>
      )}
    </>
  );
}
