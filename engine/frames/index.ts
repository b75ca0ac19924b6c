import type { Circles } from '../circles.ts';
import type { Scene } from '../scene.ts';
import type { RunEvent } from '../simulation.ts';

/** She in a frame of `arcade`, as an effect sees and changes her. Lengths in px, times in s. */
export interface Frame {
  readonly scene: Scene;
  /** The state of the simulation. */
  readonly s: Float64Array;
  number: number;
  /** Where she is, as all checks of the frame see her. */
  x: number;
  y: number;
  /** How she accelerates from the next frame on. */
  ax: number;
  ay: number;
  /** Tells what happened; null where nobody listens. */
  tell: ((event: RunEvent) => void) | null;
}

/**
 * What an effect does in the frames of `arcade`. It acts after all that the original does in a frame, before everything moves. It
 * matters where her centre is inside or close to one of its discs, and nowhere else.
 */
export interface FrameRule {
  discs(scene: Scene): Circles;
  /** Numbers of state that it needs. */
  stateLength?(scene: Scene): number;
  /** Puts into the state, from `at` on, what it is at the start. */
  layOut?(scene: Scene, s: Float64Array, at: number): void;
  /** Whether it is to be asked wherever she is. */
  isBusy?(scene: Scene, s: Float64Array, at: number): boolean;
  /** @param near indices, ascending, of at least the discs that she can be in before the next frame */
  act(frame: Frame, near: Int32Array, at: number): void;
}
