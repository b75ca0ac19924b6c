import type { SettingsStore } from '../../core/settings/index.ts';
import { everyFrame } from './every-frame.ts';
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
  /** Called when the readout should be updated. */
  readonly onReadout: (playing: Playtest) => void;
}

/** The frames of the page, which play a playtest. */
export interface PlayFrames {
  /** Plays an attempt from now on; a gun that is held counts from its first tick. null: none */
  play(playing: Playtest | null): void;
  /** The sounds of what happens in an attempt. */
  onMineral(): void;
  onEnd(playing: Playtest): void;
  stop(): void;
}

/** Runs playtests frame by frame with the input of the gun, and plays their sounds. */
export function playFrames({ element, settings, rate, onReadout }: FramesParts): PlayFrames {
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
