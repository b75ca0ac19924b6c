import { Check, Plus, RotateCcw, Route, X } from 'lucide-react';
import { useCallback, useEffect, useRef, useState } from 'react';
import { useStore } from 'zustand';
import { outcomeAsPredicate } from '../../check/words/index.ts';
import { useEditor, useLevel, useProof, useSession, useTouch } from '../context/index.ts';
import { Button } from '../ui/index.ts';
import type { Attempt } from './attempts.ts';
import { listenToGun } from './gun-input.ts';
import { keepAsRun, makeProof } from './keep-attempt.ts';
import './play.css';
import { createPlaytest, type Playtest } from './playtest.ts';
import { createSound } from './sound.ts';

/** What is shown while she flies; new a few times a second, since the canvas itself shows every frame. */
interface Readout {
  readonly tick: number;
  readonly minerals: number;
  readonly speed: number;
}

/** ms between two readouts */
const READOUT = 100;

const read = (play: Playtest): Readout => ({
  tick: play.tick,
  minerals: play.minerals,
  speed: play.speed,
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
  // what was played, once it is over
  const [attempt, setAttempt] = useState<Attempt | null>(null);

  /** Puts what was played so far among the attempts. */
  const keep = useCallback(
    (playing: Playtest): Attempt => {
      const { accuracy } = level.proof.proof();
      const { end, tick, minerals } = playing;
      return level.attempts.add({ holds: playing.holds(), end, tick, minerals, accuracy, points: playing.points() });
    },
    [level],
  );
  /** Whoever leaves, or begins again, before it is over loses nothing. */
  const abandon = useCallback(() => {
    const playing = play.current;
    play.current = null;
    if (playing !== null && playing.end === null && playing.tick > playing.startTick) keep(playing);
  }, [keep]);
  const toGun = useCallback(() => host.current?.focus({ preventScroll: true }), []);

  const start = useCallback(() => {
    abandon();
    const { run, scene } = level.proof.proof();
    const { tick } = editor.session.getState();
    const playing = createPlaytest(scene, from === 'scrubbed' ? { holds: run.holds, tick } : null);
    play.current = playing;
    level.playtest.setState({ pose: () => playing.pose() }, true);
    setReadout(read(playing));
    setAttempt(null);
    // the button that began it anew is gone, and the focus with it
    toGun();
  }, [editor, level, from, abandon, toGun]);

  const leave = useCallback(() => editor.session.setState({ mode: 'edit' }), [editor]);

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
        setAttempt(keep(playing));
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
      abandon();
    };
  }, [editor, level, start, keep, abandon]);

  const won = attempt?.end?.outcome === 'completed';
  const promote = useCallback(() => {
    if (attempt === null) return;
    (won ? makeProof : keepAsRun)({ editor, level }, attempt);
    leave();
  }, [editor, level, attempt, won, leave]);

  useEffect(
    () =>
      editor.commands.register([
        { id: 'play.stop', title: 'Back to editing', group: 'Play', mode: 'play', keys: ['Escape'], run: leave },
        { id: 'play.restart', title: 'Play again', group: 'Play', mode: 'play', keys: ['r'], run: start },
        {
          id: 'play.promote',
          title: won ? 'Make this attempt the proof' : 'Keep this attempt as a run',
          group: 'Play',
          mode: 'play',
          keys: ['Enter'],
          needs: () => (attempt === null ? 'the attempt has not ended' : null),
          run: promote,
        },
      ]),
    [editor, leave, start, promote, attempt, won],
  );

  const touch = useTouch();
  const isRunShown = useStore(editor.settings, ({ runInPlay }) => runInPlay);
  const hasRun = useProof(({ run }) => run.name !== null);
  const end = attempt?.end ?? null;
  const { minerals: all, range } = level.proof.proof().level;
  const gun = touch ? 'hold a finger on the screen' : 'hold the mouse button';
  return (
    <div ref={host} className="play" tabIndex={-1} role="application" aria-label={`Playtest: ${gun} to fire the gun`}>
      <div className="play__hud">
        <div className="play__readout numbers" aria-hidden>
          <span>{((readout?.tick ?? 0) / 60).toFixed(2)} s</span>
          <span>{Math.round(readout?.speed ?? 0)} px/s</span>
          {all.length > 0 && (
            <span>
              minerals {readout?.minerals ?? 0}/{all.length}
            </span>
          )}
          <span className="play__hint">{touch ? `${gun}: gun` : `${gun} or Space: gun · R again · Esc edit`}</span>
        </div>
        <div className="play__tools">
          {hasRun && (
            <Button
              hint="Show the run's way"
              shortcut="W"
              icon={<Route size={15} />}
              pressed={isRunShown}
              onClick={() => {
                editor.settings.setState({ runInPlay: !isRunShown });
                toGun();
              }}
            />
          )}
          {/* who has no keys */}
          {touch && end === null && (
            <>
              <Button hint="Play again" icon={<RotateCcw size={15} />} onClick={start} />
              <Button hint="Back to editing" icon={<X size={15} />} onClick={leave} />
            </>
          )}
        </div>
      </div>
      {end !== null && (
        <div className={`play__end play__end--${won ? 'won' : 'lost'}`} role="status">
          <strong>{won ? 'Through!' : 'Not this time'}</strong>
          <span>She {outcomeAsPredicate(end, range)}.</span>
          <span className="play__actions">
            <Button
              hint="Play again"
              shortcut="R"
              look={won ? 'outlined' : 'main'}
              icon={<RotateCcw size={15} />}
              onClick={start}
            >
              Again
            </Button>
            <Button
              hint={won ? 'Put this attempt into the level as its proof' : 'Put this attempt into the level as its last run'}
              shortcut="Enter"
              look={won ? 'main' : 'outlined'}
              icon={won ? <Check size={15} /> : <Plus size={15} />}
              onClick={promote}
            >
              {won ? 'Make this the proof' : 'Keep as a run'}
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
