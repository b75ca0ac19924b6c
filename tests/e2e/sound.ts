/** What a page has made sound with. */
export interface Heard {
  contexts: number;
  /** Started so far. */
  oscillators: number;
  /** Levels that something was asked to go to, in order. */
  levels: number[];
}

/** Runs in a page before its own scripts: in place of the browser's sound, something that counts. */
export function listenToSound(): void {
  const heard: Heard = { contexts: 0, oscillators: 0, levels: [] };
  class Param {
    value = 0;
    setTargetAtTime(target: number) {
      heard.levels.push(target);
    }
    setValueAtTime() {}
    linearRampToValueAtTime() {}
    exponentialRampToValueAtTime() {}
  }
  /** A pitch is no level. */
  class Pitch extends Param {
    override setTargetAtTime() {}
  }
  class Part {
    readonly gain = new Param();
    readonly frequency = new Pitch();
    connect<T>(next: T): T {
      return next;
    }
    start() {
      heard.oscillators++;
    }
    stop() {}
  }
  class Context {
    readonly state = 'running';
    readonly currentTime = 0;
    readonly destination = new Part();
    constructor() {
      heard.contexts++;
    }
    resume() {}
    close() {}
  }
  Object.assign(window, { heard, AudioContext: Context, GainNode: Part, OscillatorNode: Part, BiquadFilterNode: Part });
}
