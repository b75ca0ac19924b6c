import type { SettingsStore } from '../settings/index.ts';
import { listenToGun } from './gun-input.ts';
import type { Playtest } from './playtest.ts';
import { createSound } from './sound.ts';

/** ms between two readouts */
const READOUT = 100;

interface FramesParts {
  /** The element that receives the pointer. */
  readonly element: HTMLElement;
  readonly settings: SettingsStore;
  /** Simulated seconds per second. */
  readonly rate: () => number;
  /** The playtest; null: none. */
  readonly playing: () => Playtest | null;
  /** Called when the readout should be updated. */
  readonly onReadout: (playing: Playtest) => void;
  /** Called once when a playtest ends. */
  readonly onEnd: (playing: Playtest) => void;
}

/** Runs the playtest frame by frame with the input of the gun, and plays its sounds. @returns stops it */
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
