import type { Recorder } from '../motion/index.ts';
import type { RunEvent } from '../simulation.ts';

/** Gives the events of a simulation to a list, and keeps nothing else. */
export class EventRecorder implements Recorder {
  readonly keeps = false;

  /** @param events - receives the events */
  constructor(private readonly events: RunEvent[]) {}

  piece(): void {}

  event(event: RunEvent): void {
    this.events.push(event);
  }
}
