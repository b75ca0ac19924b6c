import type { Settings } from './settings.ts';

/** The sounds of the game, made by oscillators: there are no files to load. */
export interface Sound {
  /** Follows the gun. Call it once per frame. @param speed px/s, which sets the pitch of the hum */
  gun(isHeld: boolean, speed: number): void;
  /** @param count minerals so far: the pitch rises with each */
  mineral(count: number): void;
  /** The gun has found an asteroid. */
  target(): void;
  wake(): void;
  /** Two aliens have met. */
  explosion(): void;
  /** She leaves a wormhole. */
  passage(): void;
  death(): void;
  completion(): void;
  /** Falls silent, for example while the game is paused. */
  rest(): void;
  /** Browsers allow sound after a gesture only; call it in one. */
  unlock(): void;
}

/** s: time constant with which the hum follows. */
const GLIDE = 0.04;
const HUM_LEVEL = 0.13;
/** Hz: the pitch of the hum of somebody at rest, and how much it rises per px/s. */
const HUM_BASE = 68;
const HUM_RISE = 0.3;
/** px/s: smaller changes of speed are not heard, and need no call. */
const AUDIBLE_CHANGE = 2;
/** Hz: a pentatonic scale, on which any order of notes sounds well. */
const SCALE = [659.3, 784, 880, 1046.5, 1174.7, 1318.5];

interface Parts {
  readonly context: AudioContext;
  readonly out: AudioNode;
  readonly hum: OscillatorNode;
  readonly humLevel: GainNode;
}

function build(): Parts {
  const context = new AudioContext({ latencyHint: 'interactive' });
  const out = new GainNode(context, { gain: 0.5 });
  out.connect(context.destination);
  const humLevel = new GainNode(context, { gain: 0 });
  const soft = new BiquadFilterNode(context, { type: 'lowpass', frequency: 420 });
  const hum = new OscillatorNode(context, { type: 'sawtooth', frequency: HUM_BASE });
  hum.connect(soft).connect(humLevel).connect(out);
  hum.start();
  return { context, out, hum, humLevel };
}

/** @param settings `muted` is read before each sound */
export function createSound(settings: Settings): Sound {
  let parts: Parts | null = null;
  let isBroken = false;
  let shownLevel = 0;
  let shownSpeed = 0;

  const level = (wanted: number) => {
    if (parts === null || wanted === shownLevel) return;
    shownLevel = wanted;
    parts.humLevel.gain.setTargetAtTime(wanted, parts.context.currentTime, GLIDE);
  };
  const tone = (frequency: number, at: number, length: number, type: OscillatorType, loudness: number, to = frequency) => {
    if (parts === null || settings.muted) return;
    const { context, out } = parts;
    const start = context.currentTime + at;
    const gain = new GainNode(context, { gain: 0 });
    const oscillator = new OscillatorNode(context, { type, frequency });
    oscillator.frequency.setValueAtTime(frequency, start);
    oscillator.frequency.exponentialRampToValueAtTime(to, start + length);
    gain.gain.setValueAtTime(0, start);
    gain.gain.linearRampToValueAtTime(loudness, start + 0.01);
    gain.gain.exponentialRampToValueAtTime(0.0001, start + length);
    oscillator.connect(gain).connect(out);
    oscillator.start(start);
    oscillator.stop(start + length);
  };

  return {
    gun(isHeld, speed) {
      level(isHeld && !settings.muted ? HUM_LEVEL : 0);
      if (parts === null || shownLevel === 0 || Math.abs(speed - shownSpeed) < AUDIBLE_CHANGE) return;
      shownSpeed = speed;
      parts.hum.frequency.setTargetAtTime(HUM_BASE + HUM_RISE * speed, parts.context.currentTime, GLIDE);
    },
    mineral(count) {
      const pitch = SCALE[Math.min(count, SCALE.length) - 1];
      tone(pitch, 0, 0.28, 'sine', 0.3);
      tone(1.5 * pitch, 0.06, 0.34, 'sine', 0.2);
    },
    target: () => tone(150, 0, 0.09, 'triangle', 0.22, 240),
    wake() {
      tone(330, 0, 0.14, 'square', 0.06, 500);
      tone(330, 0.16, 0.14, 'square', 0.06, 560);
    },
    explosion: () => tone(140, 0, 0.35, 'square', 0.16, 30),
    passage: () => tone(240, 0, 0.3, 'sine', 0.24, 960),
    death() {
      level(0);
      tone(180, 0, 0.5, 'sawtooth', 0.3, 40);
      tone(90, 0.02, 0.6, 'square', 0.13, 30);
    },
    completion() {
      level(0);
      tone(220, 0, 0.7, 'sine', 0.2, 55);
      for (const [i, pitch] of [392, 493.9, 587.3, 784, 987.8].entries()) tone(pitch, 0.12 + 0.09 * i, 0.5, 'triangle', 0.24);
    },
    rest: () => level(0),
    unlock() {
      if (isBroken) return;
      try {
        parts ??= build();
        if (parts.context.state === 'suspended') void parts.context.resume();
      } catch {
        // without Web Audio the game is silent
        isBroken = true;
      }
    },
  };
}
