import { CircleCheck, CircleDashed, CircleHelp, CircleX, FileWarning } from 'lucide-react';
import type { ComponentType } from 'react';

/** The verdict of a level in the list, as far as it is known. */
export type ListedVerdict = 'completable' | 'broken' | 'unproven' | 'impossible' | 'invalid' | 'unreadable' | 'unknown';

const SIGNS: Readonly<Record<ListedVerdict, { Icon: ComponentType<{ size: number }>; word: string }>> = {
  completable: { Icon: CircleCheck, word: 'completable' },
  broken: { Icon: CircleX, word: 'broken' },
  unproven: { Icon: CircleHelp, word: 'unproven' },
  impossible: { Icon: CircleX, word: 'impossible' },
  invalid: { Icon: FileWarning, word: 'invalid' },
  unreadable: { Icon: FileWarning, word: 'unreadable' },
  unknown: { Icon: CircleDashed, word: 'checking' },
};

/** A verdict as an icon and a word. */
export function VerdictSign({ verdict }: { verdict: ListedVerdict }) {
  const { Icon, word } = SIGNS[verdict];
  return (
    <span className={`verdict verdict--${verdict}`}>
      <Icon size={12} aria-hidden />
      {word}
    </span>
  );
}
