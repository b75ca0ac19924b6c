import type { PlayerOptions } from '../../game/index.ts';
import type { Skin } from '../skin/index.ts';

/** What plays the gun's button. */
export interface InputOptions {
  /** Mouse, pen and fingers on the canvas; on when left out. What is pressed on an interactive game object does not count. */
  readonly pointer?: boolean;
  /** Keys by `KeyboardEvent.code`; `Space` and `ArrowUp` when left out, none if empty. */
  readonly keys?: readonly string[];
  /** Gamepads: any of the face buttons, shoulders and triggers; on when left out. The game needs `input: { gamepad: true }`. */
  readonly gamepad?: boolean;
}

/** A rectangle of the canvas, px. */
export interface Area {
  /** Left edge. */
  readonly x: number;
  /** Top edge. */
  readonly y: number;
  /** Width. */
  readonly width: number;
  /** Height. */
  readonly height: number;
}

/**
 * What is visible: the whole level (`fit`), what is around her (`follow`), or what the game decides (`none`: a px of the level
 * is a px of the scene, whose own camera shows it).
 */
export type CameraMode = 'fit' | 'follow' | 'none';

/** Options of {@link createRunner}. */
export interface RunnerOptions extends PlayerOptions {
  /** How things look; what is left out looks as in the default skin. */
  readonly skin?: Partial<Skin>;
  /** What is visible; `fit` when left out. */
  readonly camera?: CameraMode;
  /** The part of the canvas into which the level is fitted; all that the scene's camera shows when left out. Asked every frame. */
  readonly area?: () => Area;
  /** What plays the gun's button; false: nothing, the game calls `runner.player.press()` and `release()`. */
  readonly input?: InputOptions | false;
  /**
   * Time from a death to the next attempt, ms; 700 when left out, 0 for the next frame, null for never. Pressing the button
   * shortens it. After completion nothing restarts by itself.
   */
  readonly restartAfter?: number | null;
  /** Called after the runner has begun a new attempt. */
  readonly onRestart?: () => void;
  /** The depth of the runner's game objects in the scene; 0 when left out. */
  readonly depth?: number;
}
