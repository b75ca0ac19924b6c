import { useCallback, useEffect, useRef } from 'react';
import { useEditor, useLevel, useTouch } from '../../core/context/index.ts';
import { keepAsRun, makeProof } from '../../core/levels/index.ts';
import { PlayEnd } from './PlayEnd.tsx';
import { PlayHud } from './PlayHud.tsx';
import './play.css';
import { usePlaytest } from './use-playtest.ts';

/** The playtest over the canvas: it takes the gun's input and plays in fixed ticks. */
export function PlayView() {
  const editor = useEditor();
  const level = useLevel();
  const host = useRef<HTMLDivElement>(null);
  const { readout, attempt, start } = usePlaytest(host);
  const toGun = useCallback(() => host.current?.focus({ preventScroll: true }), []);
  const leave = useCallback(() => editor.session.setState({ mode: 'edit' }), [editor]);
  const won = attempt?.end?.outcome === 'completed';
  const promote = useCallback(() => {
    if (attempt === null) return;
    (won ? makeProof : keepAsRun)({ editor, level }, attempt);
    leave();
  }, [editor, level, attempt, won, leave]);

  useEffect(
    () =>
      editor.commands.register([
        { id: 'play.stop', title: 'Back to editing', group: 'Play', mode: 'play', keys: ['Escape'], pad: 'Start', run: leave },
        { id: 'play.restart', title: 'Play again', group: 'Play', mode: 'play', keys: ['r'], pad: 'Select', run: start },
        {
          id: 'play.promote',
          title: 'Keep this attempt as a run',
          group: 'Play',
          mode: 'play',
          keys: ['Enter'],
          needs: () => (attempt === null ? 'the attempt has not ended' : null),
          run: promote,
        },
      ]),
    [editor, leave, start, promote, attempt],
  );

  const touch = useTouch();
  const end = attempt?.end ?? null;
  const gun = touch ? 'hold a finger on the screen' : 'hold the mouse button';
  return (
    <div ref={host} className="play" tabIndex={-1} role="application" aria-label={`Playtest: ${gun} to hold the gun`}>
      <PlayHud readout={readout} gun={gun} touch={touch} isOver={end !== null} onRestart={start} onLeave={leave} toGun={toGun} />
      {end !== null && <PlayEnd end={end} onRestart={start} onKeep={promote} onLeave={leave} />}
    </div>
  );
}
