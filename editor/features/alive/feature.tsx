import { useStore } from 'zustand';
import { useEditor, useLevel } from '../../core/context/index.ts';
import type { Feature } from '../feature.ts';
import { aliveInWords, aliveOf } from './index.ts';
import { ALIVE_KEY, keepAlive } from './keep-alive.ts';
import './alive.css';
import { HeartPulse } from 'lucide-react';
import { Button } from '../../core/ui/index.ts';

/** Holds that are re-timed within the step that broke a run. */
export const alive: Feature = {
  name: 'alive',
  timeline: { buttons: AliveToggle },
  offer: AliveStatus,
  commands: ({ settings }) => [
    {
      id: 'run.keep-alive',
      title: 'Keep the run alive: turn it on or off',
      group: 'Run',
      keys: [ALIVE_KEY],
      run: () => settings.setState({ keepAlive: !settings.getState().keepAlive }),
    },
  ],
  open: ({ settings, desk }, level) => keepAlive({ level, settings, desk }),
};

/** What was done to keep the shown run alive. It is read out once the change is over, not while something is dragged. */
function AliveStatus() {
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

/** Turns it on or off that a change of the level re-times the shown run. */
function AliveToggle() {
  const { settings, commands } = useEditor();
  const isOn = useStore(settings, ({ keepAlive }) => keepAlive);
  return (
    <Button
      hint={`Keep the run alive: ${isOn ? 'on. A change that breaks it re-times its holds' : 'off'}`}
      shortcut="Shift K"
      icon={<HeartPulse size={16} />}
      pressed={isOn}
      aria-label="Keep the run alive"
      onClick={() => commands.run('run.keep-alive')}
    />
  );
}
