import type { GameObjects, Scene } from 'phaser';
import type { Ghost, PlayEvent, Player } from '../../game/index.ts';
import type { Level, ObjectKind, ObjectOf } from '../../schema/basics/index.ts';
import type { GameColours } from '../drawing/index.ts';

/** The part of the canvas that shows a level, and the part of the level that it shows. */
export interface View {
  /** Left edge on the canvas, px. */
  readonly left: number;
  /** Top edge on the canvas, px. */
  readonly top: number;
  /** Width on the canvas, px. */
  readonly width: number;
  /** Height on the canvas, px. */
  readonly height: number;
  /** The place of the level in the middle, px of the level. */
  readonly x: number;
  /** See {@link View.x}. */
  readonly y: number;
  /** px of the canvas per px of the level. */
  readonly zoom: number;
}

/**
 * What a skin draws from. Its properties change from frame to frame, and its arrays are written anew: read them in
 * {@link Figure.update}, and keep none of them.
 */
export interface SkinStage {
  /** The scene that game objects are made for. */
  readonly scene: Scene;
  /** The attempt that is shown. */
  readonly player: Player;
  /** The level that is shown. */
  readonly level: Level;
  /** The colours of the default skin. */
  readonly colours: GameColours;
  /** What is visible. */
  readonly view: View;
  /** Width of what the scene's camera shows, px of the canvas. */
  readonly width: number;
  /** See {@link SkinStage.width}. */
  readonly height: number;
  /** Her state at the time that is shown: x, y (px), vx, vy (px/s), cos, sin. */
  readonly pose: Readonly<Float64Array>;
  /** x, y (px) and alive (1 or 0) of every alien. */
  readonly aliens: Readonly<Float64Array>;
  /** x, y (px) of every asteroid. */
  readonly asteroids: Readonly<Float64Array>;
  /** Time that the level has been shown, s. It goes on after the end of a play, and stands still during a pause. */
  readonly time: number;
  /** Time since the last frame, s; 0 during a pause. */
  readonly seconds: number;
  /**
   * Draws the textures of the default skin, unless that has been done.
   *
   * @param name - one of the names in `DRAWINGS`, or `glow`, `spark`, `haze`
   * @returns the key of the texture in the game's texture manager
   */
  texture(name: string): string;
}

/** What a skin makes of an object. */
export interface Figure {
  /**
   * Its game objects, in px of the level. The runner adds them to its own container in the order of their `depth`, and destroys
   * them.
   */
  readonly objects: readonly GameObjects.GameObject[];
  /** Called every frame after the player has advanced. It should allocate nothing. */
  update?(): void;
  /**
   * Called for every event of the play, after the ticks of a frame.
   *
   * @param event - what happened, with its place
   */
  onEvent?(event: PlayEvent): void;
  /** Called when another attempt begins. */
  onRestart?(): void;
  /** Called when another level is loaded or the runner is destroyed, before the game objects are destroyed. */
  onDestroy?(): void;
}

/**
 * Makes what shows an object.
 *
 * @param stage - what to draw from
 * @param object - the object, as in the level
 * @param index - its index within the level's list of its kind, from 0
 * @returns its game objects and how they change; null to show nothing
 */
export type Draw<T> = (stage: SkinStage, object: T, index: number) => Figure | null;

/** How each kind of object looks. */
export type KindSkin = { readonly [K in ObjectKind]: Draw<ObjectOf<K>> };

/** How a level looks: a function for each kind of object, and for what is around them. */
export interface Skin extends KindSkin {
  /**
   * What is behind everything. Its game objects are in px of the canvas, from the upper left corner of what the scene's
   * camera shows.
   */
  readonly background: Draw<Level>;
  /** The beam of the gun, from her to its target. */
  readonly beam: Draw<Level>;
  /** Where she has been. */
  readonly trail: Draw<Level>;
  /** A ghost; it may come and go with an attempt. */
  readonly ghost: Draw<Ghost>;
  /** What shows events: sparks, explosions, rings. */
  readonly effects: Draw<Level>;
}
