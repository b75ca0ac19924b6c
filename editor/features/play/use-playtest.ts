import { type RefObject, useCallback, useEffect, useRef, useState } from 'react';
import { encodePlay, playOf } from '../../../game/index.ts';
import type { Attempt } from '../../core/attempts/index.ts';
import { type OpenLevel, useEditor, useLevel, useSession } from '../../core/context/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import { type PlayFrames, playFrames } from './play-frames.ts';
import { createPlaytest, type Playtest } from './playtest.ts';

/** What the HUD shows; updated a few times a second, as the canvas shows every frame. */
export interface Readout {
  readonly tick: number;
  readonly minerals: number;
  readonly speed: number;
}

const read = ({ player, minerals, speed }: Playtest): Readout => ({ tick: player.tick, minerals, speed });

/** What is played: the level as it is now, the rules of its folder, and the accuracy. */
const nowOf = ({ document, proof }: OpenLevel) => {
  const { terms } = proof.proof();
  return { file: document.file(), rules: terms.rules, accuracy: accuracyNameOf(terms) };
};

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
  const from = useSession((state) => state.playFrom);
  const play = useRef<Playtest | null>(null);
  const frames = useRef<PlayFrames | null>(null);
  const begun = useRef(nowOf(level));
  const [readout, setReadout] = useState<Readout | null>(null);
  const [attempt, setAttempt] = useState<Attempt | null>(null);

  /** Adds what was played so far to the attempts. */
  const keep = useCallback(
    (playing: Playtest): Attempt => {
      const { player, end, minerals } = playing;
      const { holds, tick } = player;
      const { accuracy, file, rules } = begun.current;
      const play = playOf(player);
      const played = { bytes: encodePlay(play), hash: play.level, file, rules };
      return level.attempts.add({ holds, end, tick, minerals, accuracy, points: playing.points(), played });
    },
    [level],
  );
  /** Keeps an attempt that is left or restarted before its end. */
  const abandon = useCallback(() => {
    const playing = play.current;
    play.current = null;
    if (playing !== null && playing.end === null && playing.player.tick > playing.startTick) keep(playing);
  }, [keep]);

  const start = useCallback(() => {
    abandon();
    begun.current = nowOf(level);
    const { run, scene } = level.proof.proof();
    const { tick } = editor.session.getState();
    const playing = createPlaytest(scene, {
      from: from === 'scrubbed' ? { holds: run.holds, tick } : null,
      onMineral: () => frames.current?.onMineral(),
      onEnd(ended) {
        frames.current?.onEnd(ended);
        setAttempt(keep(ended));
        setReadout(read(ended));
      },
    });
    play.current = playing;
    frames.current?.play(playing);
    level.playtest.setState({ pose: () => playing.pose(), moment: () => playing.moment() }, true);
    setReadout(read(playing));
    setAttempt(null);
    // The button that restarted it is gone, and the focus with it.
    host.current?.focus({ preventScroll: true });
  }, [editor, level, from, keep, abandon, host]);

  useEffect(() => {
    const element = host.current;
    if (element === null) return;
    const running = playFrames({
      element,
      settings: editor.settings,
      rate: () => editor.session.getState().rate,
      onReadout: (playing) => setReadout(read(playing)),
    });
    frames.current = running;
    start();
    return () => {
      running.stop();
      frames.current = null;
      level.playtest.setState(null, true);
      abandon();
    };
  }, [editor, level, start, abandon, host]);

  return { readout, attempt, start };
}
