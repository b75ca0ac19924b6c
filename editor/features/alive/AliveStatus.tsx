import { useStore } from 'zustand';
import { useLevel } from '../../core/context/index.ts';
import { aliveOf } from './alive-state.ts';
import { aliveInWords } from './alive-words.ts';
import './alive.css';

/** What was done to keep the shown run alive. It is read out once the change is over, not while something is dragged. */
export function AliveStatus() {
  const state = useStore(aliveOf(useLevel()));
  const words = aliveInWords(state);
  const isOver = state.kind === 'others' || ((state.kind === 'alive' || state.kind === 'failed') && state.isFinal);
  return (
    <>
      {words !== null && (
        <span className={`alive alive--${state.kind} numbers`} title={words} aria-hidden={isOver}>
          {words}
        </span>
      )}
      <span className="unseen" role="status">
        {isOver ? words : ''}
      </span>
    </>
  );
}
