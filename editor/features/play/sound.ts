/** The sounds of a playtest. */
export interface Sound {
  /** The hum of the held gun, higher at higher speed. @param speed px/s */
  gun(held: boolean, speed: number): void;
  mineral(): void;
  won(): void;
  died(): void;
  close(): void;
}

const SILENCE: Sound = { gun: () => {}, mineral: () => {}, won: () => {}, died: () => {}, close: () => {} };

/** time constant in s with which the hum follows */
const GLIDE = 0.04;

/**
 * Sounds made by oscillators, no recordings.
 * @param volume read before each sound, 0 to 1; 0 is silence
 */
export function createSound(volume: () => number): Sound {
  if (typeof AudioContext === 'undefined') return SILENCE;
  let parts: { context: AudioContext; out: GainNode; hum: OscillatorNode; humLevel: GainNode } | null = null;

  // A page may make sound only after a user gesture, so the audio context is created when the first sound is wanted.
  const awake = () => {
    if (parts === null) {
      const context = new AudioContext();
      const out = new GainNode(context, { gain: volume() });
      out.connect(context.destination);
      const humLevel = new GainNode(context, { gain: 0 });
      const soft = new BiquadFilterNode(context, { type: 'lowpass', frequency: 420 });
      const hum = new OscillatorNode(context, { type: 'sawtooth', frequency: 70 });
      hum.connect(soft).connect(humLevel).connect(out);
      hum.start();
      parts = { context, out, hum, humLevel };
    }
    parts.out.gain.value = volume();
    if (parts.context.state === 'suspended') void parts.context.resume();
    return parts;
  };
  const tone = (frequency: number, at: number, length: number, type: OscillatorType, level: number, to = frequency) => {
    const { context, out } = awake();
    const start = context.currentTime + at;
    const gain = new GainNode(context, { gain: 0 });
    const oscillator = new OscillatorNode(context, { type, frequency });
    oscillator.frequency.exponentialRampToValueAtTime(to, start + length);
    gain.gain.setValueAtTime(0, start);
    gain.gain.linearRampToValueAtTime(level, start + 0.01);
    gain.gain.exponentialRampToValueAtTime(0.0001, start + length);
    oscillator.connect(gain).connect(out);
    oscillator.start(start);
    oscillator.stop(start + length);
  };
  const audible = () => volume() > 0;

  return {
    gun(held, speed) {
      if (parts === null && (!held || !audible())) return;
      const { context, hum, humLevel } = awake();
      humLevel.gain.setTargetAtTime(held && audible() ? 0.16 : 0, context.currentTime, GLIDE);
      hum.frequency.setTargetAtTime(70 + 0.25 * speed, context.currentTime, GLIDE);
    },
    mineral() {
      if (!audible()) return;
      tone(880, 0, 0.25, 'sine', 0.3);
      tone(1320, 0.06, 0.3, 'sine', 0.22);
    },
    won() {
      if (!audible()) return;
      for (const [i, frequency] of [392, 494, 587, 784].entries()) tone(frequency, 0.09 * i, 0.5, 'triangle', 0.25);
    },
    died() {
      if (!audible()) return;
      tone(180, 0, 0.5, 'sawtooth', 0.28, 40);
      tone(90, 0.02, 0.6, 'square', 0.12, 30);
    },
    close() {
      void parts?.context.close();
      parts = null;
    },
  };
}
