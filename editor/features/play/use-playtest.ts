import { type RefObject, useCallback, useEffect, useRef, useState } from 'react';
import { encodePlay, playOf } from '../../../game/index.ts';
import type { Attempt } from '../../core/attempts/index.ts';
import { type OpenLevel, useEditor, useLevel, useSession } from '../../core/context/index.ts';
import type { SettingsStore } from '../../core/settings/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import { listenToGun } from './gun-input.ts';
import { createPlaytest, type Playtest } from './playtest.ts';
import { createSound } from './sound.ts';

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

// frame by frame

/** ms between two readouts */
const READOUT = 100;

interface FramesParts {
  /** The element that receives the pointer. */
  readonly element: HTMLElement;
  readonly settings: SettingsStore;
  /** Simulated seconds per second. */
  readonly rate: () => number;
  /** Called when the readout should be updated. */
  readonly onReadout: (playing: Playtest) => void;
}

/** The frames of the page, which play a playtest. */
interface PlayFrames {
  /** Plays an attempt from now on; a gun that is held counts from its first tick. null: none */
  play(playing: Playtest | null): void;
  /** The sounds of what happens in an attempt. */
  onMineral(): void;
  onEnd(playing: Playtest): void;
  stop(): void;
}

/** Runs playtests frame by frame with the input of the gun, and plays their sounds. */
function playFrames({ element, settings, rate, onReadout }: FramesParts): PlayFrames {
  let current: Playtest | null = null;
  const gun = listenToGun(window, element, () => settings.getState().gunKey, {
    press: () => current?.player.press(),
    release: () => current?.player.release(),
  });
  const sound = createSound(() => (settings.getState().sound ? settings.getState().volume : 0));
  let shownAt = 0;
  const stopFrames = everyFrame(rate, (ms, now) => {
    if (current === null) return;
    const playing = current;
    playing.player.advance(ms);
    sound.gun(gun.isHeld() && playing.end === null, playing.speed);
    if (now - shownAt > READOUT) {
      shownAt = now;
      onReadout(playing);
    }
  });
  return {
    play(playing) {
      current = playing;
      // the user takes over from a run that may hold the gun
      if (gun.isHeld()) current?.player.press();
      else current?.player.release();
    },
    onMineral: () => sound.mineral(),
    onEnd({ end }) {
      if (end?.outcome === 'completed') sound.won();
      else sound.died();
    },
    stop() {
      stopFrames();
      gun.stop();
      sound.close();
    },
  };
}

/**
 * Calls back with every frame of the page.
 * @param rate simulated seconds per second
 * @param onFrame is given the simulated time since the last frame and the time of this one, ms
 * @returns stops it
 */
export function everyFrame(rate: () => number, onFrame: (ms: number, now: number) => void): () => void {
  let last = performance.now();
  const next = (now: number) => {
    frame = requestAnimationFrame(next);
    const ms = (now - last) * rate();
    last = now;
    onFrame(ms, now);
  };
  let frame = requestAnimationFrame(next);
  return () => cancelAnimationFrame(frame);
}
