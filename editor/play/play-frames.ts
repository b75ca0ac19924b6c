import type { SettingsStore } from '../settings/index.ts';
import { listenToGun } from './gun-input.ts';
import type { Playtest } from './playtest.ts';
import { createSound } from './sound.ts';

/** ms between two readouts */
const READOUT = 100;

interface FramesParts {
  /** What takes the pointer. */
  readonly element: HTMLElement;
  readonly settings: SettingsStore;
  /** Seconds of the game a second. */
  readonly rate: () => number;
  /** What is played; null: nothing. */
  readonly playing: () => Playtest | null;
  /** It is time to show again how it stands. */
  readonly onReadout: (playing: Playtest) => void;
  /** It is over; called once for each playtest. */
  readonly onEnd: (playing: Playtest) => void;
}

/** Plays frame by frame with what the gun is told to do, and lets it be heard. @returns stops it */
export function playFrames({ element, settings, rate, playing: current, onReadout, onEnd }: FramesParts): () => void {
  const gun = listenToGun(window, element, () => settings.getState().gunKey);
  const sound = createSound(() => (settings.getState().sound ? settings.getState().volume : 0));
  let last = performance.now();
  let shownAt = 0;
  let ended: Playtest | null = null;
  const onFrame = (now: number) => {
    frame = requestAnimationFrame(onFrame);
    const playing = current();
    const seconds = (Math.max(0, now - last) / 1000) * rate();
    last = now;
    const held = gun.read();
    if (playing === null) return;
    const before = playing.minerals;
    playing.advance(seconds, held);
    sound.gun(held && playing.end === null, playing.speed);
    if (playing.minerals > before) sound.mineral();
    if (playing.end !== null && ended !== playing) {
      ended = playing;
      if (playing.end.outcome === 'completed') sound.won();
      else sound.died();
      onEnd(playing);
    }
    if (now - shownAt > READOUT) {
      shownAt = now;
      onReadout(playing);
    }
  };
  let frame = requestAnimationFrame(onFrame);
  return () => {
    cancelAnimationFrame(frame);
    gun.stop();
    sound.close();
  };
}
