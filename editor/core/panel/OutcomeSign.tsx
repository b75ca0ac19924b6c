import { CircleCheck, CircleDotDashed, Clock, Skull, Unlink } from 'lucide-react';
import type { ComponentType } from 'react';
import type { Outcome } from '../../../engine/index.ts';

const SIGNS: Readonly<Record<Outcome, { Icon: ComponentType<{ size: number }>; word: string; look: string }>> = {
  completed: { Icon: CircleCheck, word: 'completes', look: 'good' },
  collided: { Icon: Skull, word: 'collides', look: 'bad' },
  lost: { Icon: Unlink, word: 'is lost', look: 'bad' },
  timeout: { Icon: Clock, word: 'times out', look: 'warn' },
};

/** The end of a run in one word or two. */
export const outcomeWord = (outcome: Outcome | null): string => (outcome === null ? 'not simulated yet' : SIGNS[outcome].word);

/** The end of a run as an icon beside the word. */
export function OutcomeSign({ outcome }: { outcome: Outcome | null }) {
  if (outcome === null) {
    return (
      <span className="runs__sign">
        <CircleDotDashed size={15} aria-hidden />
      </span>
    );
  }
  const { Icon, look } = SIGNS[outcome];
  return (
    <span className={`runs__sign runs__sign--${look}`}>
      <Icon size={15} aria-hidden />
    </span>
  );
}
