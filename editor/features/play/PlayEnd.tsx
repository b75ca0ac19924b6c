import { Check, Plus, RotateCcw, X } from 'lucide-react';
import { useRef } from 'react';
import { outcomeAsPredicate, type RunEnd } from '../../../check/words/index.ts';
import { useLevel } from '../../core/context/index.ts';
import { Button } from '../../core/ui/index.ts';
import { usePadChoice } from './use-pad-choice.ts';

interface PlayEndProps {
  readonly end: RunEnd;
  readonly onRestart: () => void;
  /** Adds what was played to the level. */
  readonly onKeep: () => void;
  readonly onLeave: () => void;
}

/** How a playtest ended, and what to do with it. */
export function PlayEnd({ end, onRestart, onKeep, onLeave }: PlayEndProps) {
  const { range } = useLevel().proof.proof().level;
  const won = end.outcome === 'completed';
  const panel = useRef<HTMLDivElement>(null);
  usePadChoice(panel);
  return (
    <div ref={panel} className={`play__end play__end--${won ? 'won' : 'lost'}`} role="status">
      <strong>{won ? 'Level completed' : 'Not completed'}</strong>
      <span>She {outcomeAsPredicate(end, range)}.</span>
      <span className="play__actions">
        <Button
          hint="Play again"
          shortcut="R"
          look={won ? 'outlined' : 'main'}
          icon={<RotateCcw size={15} />}
          onClick={onRestart}
        >
          Again
        </Button>
        <Button
          hint={
            won ? 'Keep this attempt in the level as the run that completes it' : 'Keep this attempt in the level as its last run'
          }
          shortcut="Enter"
          look={won ? 'main' : 'outlined'}
          icon={won ? <Check size={15} /> : <Plus size={15} />}
          onClick={onKeep}
        >
          Keep as a run
        </Button>
        <Button hint="Back to editing" shortcut="Esc" look="outlined" icon={<X size={15} />} onClick={onLeave}>
          Edit
        </Button>
      </span>
    </div>
  );
}
