import { Check, RotateCcw, X } from 'lucide-react';
import { useCallback, useEffect, useRef, useState } from 'react';
import { useEditor, useLevel, useSession } from '../context/index.ts';
import { addRun, freeRunName, replaceHolds } from '../document/index.ts';
import { outcomeInWords } from '../proof/index.ts';
import { Button } from '../ui/index.ts';
import { listenToGun } from './gun-input.ts';
import './play.css';
import { createPlaytest, type Playtest } from './playtest.ts';
import { createSound } from './sound.ts';

/** What is shown while she flies; new a few times a second, since the canvas itself shows every frame. */
interface Readout {
  readonly tick: number;
  readonly minerals: number;
  readonly speed: number;
  readonly over: boolean;
}

/** ms between two readouts */
const READOUT = 100;

const read = (play: Playtest): Readout => ({
  tick: play.tick,
  minerals: play.minerals,
  speed: play.speed,
  over: play.end !== null,
});

/** The playtest over the canvas: takes the gun's input, plays in fixed ticks, keeps out of the way. */
export function PlayView() {
  const editor = useEditor();
  const level = useLevel();
  const rate = useSession((state) => state.rate);
  const from = useSession((state) => state.playFrom);
  const host = useRef<HTMLDivElement>(null);
  const play = useRef<Playtest | null>(null);
  const rateNow = useRef(rate);
  rateNow.current = rate;
  const [readout, setReadout] = useState<Readout | null>(null);

  const start = useCallback(() => {
    const { run, scene } = level.proof.proof();
    const { tick } = editor.session.getState();
    play.current = createPlaytest(scene, from === 'scrubbed' ? { holds: run.holds, tick } : null);
    level.playtest.setState({ pose: () => (play.current as Playtest).pose() }, true);
    setReadout(read(play.current));
    // the button that began it anew is gone, and the focus with it
    host.current?.focus({ preventScroll: true });
  }, [editor, level, from]);

  const leave = useCallback(() => editor.session.setState({ mode: 'edit' }), [editor]);

  /** Puts the attempt into the level: in place of the shown run when that doesn't complete it, else as a run of its own, shown first. */
  const promote = useCallback(() => {
    const now = play.current;
    if (now === null || now.end === null) return;
    const { run } = level.proof.proof();
    const holds = now.holds();
    const file = level.document.file();
    if (run.name !== null && run.outcome !== 'completed') {
      level.document.change('Make the attempt the proof', replaceHolds(run.name, holds));
    } else {
      const name = freeRunName(file, run.name === null ? 'solution' : 'played');
      level.document.change('Make the attempt the proof', addRun(name, holds, 'first'));
      editor.session.setState({ run: name });
    }
    editor.notices.show('info', `The attempt is a run of the level now: ${holds.length} holds.`, { topic: 'promoted' });
    leave();
  }, [editor, level, leave]);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    start();
    const { settings } = editor;
    const gun = listenToGun(window, element, () => settings.getState().gunKey);
    const sound = createSound(() => (settings.getState().sound ? settings.getState().volume : 0));
    let frame = 0;
    let last = performance.now();
    let shownAt = 0;
    let kept: Playtest | null = null;
    const onFrame = (now: number) => {
      frame = requestAnimationFrame(onFrame);
      const playing = play.current;
      const seconds = (Math.max(0, now - last) / 1000) * rateNow.current;
      last = now;
      const held = gun.read();
      if (playing === null) return;
      const before = playing.minerals;
      playing.advance(seconds, held);
      sound.gun(held && playing.end === null, playing.speed);
      if (playing.minerals > before) sound.mineral();
      if (playing.end !== null && kept !== playing) {
        kept = playing;
        if (playing.end.outcome === 'completed') sound.won();
        else sound.died();
        const { accuracy } = level.proof.proof();
        level.attempts.add({
          holds: playing.holds(),
          end: playing.end,
          minerals: playing.minerals,
          accuracy,
          points: playing.points(),
        });
        setReadout(read(playing));
      }
      if (now - shownAt > READOUT) {
        shownAt = now;
        setReadout(read(playing));
      }
    };
    frame = requestAnimationFrame(onFrame);
    return () => {
      cancelAnimationFrame(frame);
      gun.stop();
      sound.close();
      level.playtest.setState(null, true);
      play.current = null;
    };
  }, [editor, level, start]);

  useEffect(
    () =>
      editor.commands.register([
        { id: 'play.stop', title: 'Back to editing', group: 'Play', mode: 'play', keys: ['Escape'], run: leave },
        { id: 'play.restart', title: 'Play again', group: 'Play', mode: 'play', keys: ['r'], run: start },
        {
          id: 'play.promote',
          title: 'Make this attempt the proof',
          group: 'Play',
          mode: 'play',
          keys: ['Enter'],
          needs: () => (play.current?.end === null ? 'the attempt has not ended' : null),
          run: promote,
        },
      ]),
    [editor, leave, start, promote],
  );

  const end = readout?.over === true ? (play.current?.end ?? null) : null;
  const { minerals: all, range } = level.proof.proof().level;
  return (
    <div
      ref={host}
      className="play"
      tabIndex={-1}
      role="application"
      aria-label="Playtest: hold the mouse button to fire the gun"
    >
      <div className="play__readout numbers" aria-hidden>
        <span>{((readout?.tick ?? 0) / 60).toFixed(2)} s</span>
        <span>{Math.round(readout?.speed ?? 0)} px/s</span>
        {all.length > 0 && (
          <span>
            minerals {readout?.minerals ?? 0}/{all.length}
          </span>
        )}
        <span className="play__hint">hold the mouse button, a finger or Space: gun · R again · Esc edit</span>
      </div>
      {end !== null && (
        <div className={`play__end play__end--${end.outcome === 'completed' ? 'won' : 'lost'}`} role="status">
          <strong>{end.outcome === 'completed' ? 'Through!' : 'Not this time'}</strong>
          <span>She {outcomeInWords(end, range)}.</span>
          <span className="play__actions">
            <Button hint="Play again" shortcut="R" look="outlined" icon={<RotateCcw size={15} />} onClick={start}>
              Again
            </Button>
            <Button
              hint="Put this attempt into the level as a run"
              shortcut="Enter"
              look={end.outcome === 'completed' ? 'main' : 'outlined'}
              icon={<Check size={15} />}
              onClick={promote}
            >
              Make this the proof
            </Button>
            <Button hint="Back to editing" shortcut="Esc" look="outlined" icon={<X size={15} />} onClick={leave}>
              Edit
            </Button>
          </span>
        </div>
      )}
    </div>
  );
}
