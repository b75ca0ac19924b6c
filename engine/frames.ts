import type { IndexedCircles } from './indexed-circles.ts';
import type { Scene } from './scene.ts';
import type { RunEvent } from './simulation.ts';

/** The astronaut in a frame of `arcade`, as an effect sees and changes her. Lengths are in px, times in s. */
export interface Frame {
  readonly scene: Scene;
  /** The state of the simulation. */
  readonly s: Float64Array;
  number: number;
  /** Her place, as all tests of the frame use it. */
  x: number;
  y: number;
  /** Her acceleration from the next frame on. */
  ax: number;
  ay: number;
  /** Reports an event; null if nobody listens. */
  tell: ((event: RunEvent) => void) | null;
}

/**
 * What an effect does in the frames of `arcade`. It acts after everything that the original game does in a frame, before
 * anything moves. It matters only while her centre is inside or close to one of its discs.
 */
export interface FrameRule {
  discs(scene: Scene): IndexedCircles;
  /** Set if each disc near her counts as a look of the budget. */
  readonly isWork?: true;
  /** Number of doubles of state that it needs. */
  stateLength?(scene: Scene): number;
  /** Writes its state at the start of a run, from `at` on. */
  layOut?(scene: Scene, s: Float64Array, at: number): void;
  /** Whether it must be called wherever she is. */
  isBusy?(scene: Scene, s: Float64Array, at: number): boolean;
  /**
   * Acts on a frame.
   * @param near - indices, ascending, of at least the discs that she can be in before the next frame
   */
  act(frame: Frame, near: Int32Array, at: number): void;
}
