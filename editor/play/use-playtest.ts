import { type RefObject, useCallback, useEffect, useRef, useState } from 'react';
import type { Attempt } from '../attempts/index.ts';
import { useEditor, useLevel, useSession } from '../context/index.ts';
import { playFrames } from './play-frames.ts';
import { createPlaytest, type Playtest } from './playtest.ts';

/** What the HUD shows; updated a few times a second, as the canvas shows every frame. */
export interface Readout {
  readonly tick: number;
  readonly minerals: number;
  readonly speed: number;
}

const read = ({ tick, minerals, speed }: Playtest): Readout => ({ tick, minerals, speed });

interface PlaytestOnPage {
  readonly readout: Readout | null;
  /** The finished attempt, once the playtest has ended. */
  readonly attempt: Attempt | null;
  /** Starts again. */
  readonly start: () => void;
}

/** Plays the level while the component is mounted. @param host the element that receives the gun's input and the focus */
export function usePlaytest(host: RefObject<HTMLDivElement | null>): PlaytestOnPage {
  const editor = useEditor();
  const level = useLevel();
  const rate = useSession((state) => state.rate);
  const from = useSession((state) => state.playFrom);
  const play = useRef<Playtest | null>(null);
  const rateNow = useRef(rate);
  rateNow.current = rate;
  const [readout, setReadout] = useState<Readout | null>(null);
  const [attempt, setAttempt] = useState<Attempt | null>(null);

  /** Adds what was played so far to the attempts. */
  const keep = useCallback(
    (playing: Playtest): Attempt => {
      const { accuracy } = level.proof.proof();
      const { end, tick, minerals } = playing;
      return level.attempts.add({ holds: playing.holds(), end, tick, minerals, accuracy, points: playing.points() });
    },
    [level],
  );
  /** Keeps an attempt that is left or restarted before its end. */
  const abandon = useCallback(() => {
    const playing = play.current;
    play.current = null;
    if (playing !== null && playing.end === null && playing.tick > playing.startTick) keep(playing);
  }, [keep]);

  const start = useCallback(() => {
    abandon();
    const { run, scene } = level.proof.proof();
    const { tick } = editor.session.getState();
    const playing = createPlaytest(scene, from === 'scrubbed' ? { holds: run.holds, tick } : null);
    play.current = playing;
    level.playtest.setState({ pose: () => playing.pose() }, true);
    setReadout(read(playing));
    setAttempt(null);
    // The button that restarted it is gone, and the focus with it.
    host.current?.focus({ preventScroll: true });
  }, [editor, level, from, abandon, host]);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    start();
    const stop = playFrames({
      element,
      settings: editor.settings,
      rate: () => rateNow.current,
      playing: () => play.current,
      onReadout: (playing) => setReadout(read(playing)),
      onEnd(playing) {
        setAttempt(keep(playing));
        setReadout(read(playing));
      },
    });
    return () => {
      stop();
      level.playtest.setState(null, true);
      abandon();
    };
  }, [editor, level, start, keep, abandon, host]);

  return { readout, attempt, start };
}
