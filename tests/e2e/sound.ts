/** The sounds that a page has made. */
export interface Heard {
  contexts: number;
  /** The number of sources started so far. */
  oscillators: number;
  /** The requested sound levels, in order. */
  levels: number[];
}

/** Runs in a page before its own scripts: replaces the browser's audio by an object that counts. */
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
  /** The parameter of a pitch, which is not recorded as a level. */
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
