import { CANVAS, Game, Scale, Scene, type Types, WEBGL } from 'phaser';
import type { Box } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import type { Ghost, Pose } from '../core/context/index.ts';
import type { ObjectKey } from '../core/document/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import type { Layer } from '../core/session/index.ts';
import type { DeathMap } from '../core/shelf/index.ts';
import type { Racer } from '../features/compare/index.ts';
import type { LostPicture } from '../features/lost/index.ts';
import type { OnionPicture } from '../features/onion/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { COLOURS, type Theme } from './colours.ts';
import { isFrameDue } from './frame-pace.ts';
import {
  AstronautLayer,
  DeathLayer,
  LostLayer,
  ObjectLayer,
  OnionLayer,
  OverlayLayer,
  RaceLayer,
  SearchLayer,
  type SearchPicture,
  SpaceScene,
  WayLayer,
} from './layers/index.ts';
import type { RendererName } from './renderer.ts';
import { drawTextures } from './textures/index.ts';

/** Everything that a frame shows. Parts that are the same object as in the last frame are not drawn again. */
export interface Picture {
  readonly file: LevelFile;
  /** The astronaut's collision box under the rules of the level; the same object while its size stays. */
  readonly her: Box;
  readonly proof: LiveProof;
  readonly canvas: CanvasState;
  readonly selected: readonly ObjectKey[];
  readonly hovered: ObjectKey | null;
  readonly layers: Readonly<Record<Layer, boolean>>;
  /** px; null: no grid */
  readonly grid: number | null;
  readonly ghosts: readonly Ghost[];
  readonly search: SearchPicture;
  /** Where players die in the opened plays; null: not known. */
  readonly deaths: DeathMap | null;
  /** Where the level is already lost; null: it is not shown. */
  readonly lost: LostPicture | null;
  /** The level as it was before a change; null: it is not shown. */
  readonly onion: OnionPicture | null;
  readonly pose: Pose;
  /** The compared runs that are shown; the same list until one of them changes. */
  readonly racers: readonly Racer[];
  /** The tick at which they are shown, with a fraction. */
  readonly moment: number;
  readonly editing: boolean;
  /** Whether the path of the run is shown. */
  readonly showsRun: boolean;
  readonly theme: Theme;
  /** Whether the user wants reduced motion. */
  readonly calm: boolean;
}

/** The layers, drawn in one theme. */
interface Layers {
  readonly theme: Theme;
  readonly overlay: OverlayLayer;
  readonly search: SearchLayer;
  readonly deaths: DeathLayer;
  readonly lost: LostLayer;
  readonly onion: OnionLayer;
  readonly way: WayLayer;
  readonly race: RaceLayer;
  readonly astronaut: AstronautLayer;
}

/** Draws what it is given; it holds no state of the level. */
class LevelScene extends Scene {
  private objects: ObjectLayer | null = null;
  private layers: Layers | null = null;
  private picture: (() => Picture) | null = null;
  private last: Picture | null = null;
  /** What this frame would show. */
  private next: Picture | null = null;
  /** When the last frame was drawn, ms. */
  private drawn = Number.NEGATIVE_INFINITY;

  constructor() {
    super('level');
  }

  /** Reads the picture. @returns whether a frame at this time, ms, would show anything new */
  isDue(time: number): boolean {
    this.next = this.picture?.() ?? null;
    const { last, next, drawn } = this;
    return last === null || next === null || isFrameDue(last, next, time - drawn);
  }

  create(): void {
    this.objects = new ObjectLayer(this);
  }

  /** Shows the pictures of another level from now on; null: none. */
  show(picture: (() => Picture) | null): void {
    this.picture = picture;
    this.last = null;
    // another level may have different objects with the same ids
    this.objects?.clear();
  }

  override update(time: number): void {
    const { objects, last, next: picture } = this;
    this.drawn = time;
    if (picture === null || objects === null) return;
    const space = this.scene.get('space') as SpaceScene;
    const isRedressed = this.layers?.theme !== picture.theme;
    if (isRedressed) this.layers = this.dress(picture.theme, objects, space);
    const { overlay, search, deaths, lost, onion, way, race, astronaut } = this.layers as Layers;
    const fresh = last === null || isRedressed;
    const { view } = picture.canvas;
    if (fresh || last.canvas.view !== view) {
      this.cameras.main.setZoom(view.zoom).centerOn(view.x, view.y);
      space.show(view);
    }
    objects.show(picture.file, picture.editing);
    const zoomed = fresh || last.canvas.view.zoom !== view.zoom;
    const same = (...names: readonly (keyof Picture)[]) => !fresh && names.every((name) => last[name] === picture[name]);
    if (!same('file', 'her', 'canvas', 'selected', 'hovered', 'layers', 'grid', 'editing')) overlay.show(picture);
    if (zoomed || !same('proof', 'ghosts', 'layers', 'showsRun')) way.show({ ...picture, zoom: view.zoom });
    if (zoomed || !same('racers', 'her')) race.show({ ...picture, zoom: view.zoom });
    if (zoomed || !same('racers', 'moment')) race.pose(picture.racers, picture.moment, view.zoom, picture.her);
    if (zoomed || !same('search', 'layers')) search.show(picture.search, picture.layers.heatMap, view.zoom);
    if (!same('deaths', 'layers')) deaths.show(picture.layers.deaths ? picture.deaths : null);
    if (zoomed || !same('lost')) lost.show(picture.lost, view.zoom);
    if (zoomed || !same('onion')) onion.show(picture.onion, view.zoom);
    if (zoomed || !same('file', 'pose', 'editing')) objects.pose(picture.pose, view.zoom);
    const seconds = time / 1000;
    if (!picture.calm) objects.animate(seconds, view.zoom);
    astronaut.show(picture.pose, picture.file.astronaut, picture.her, seconds, picture.calm);
    this.last = picture;
  }

  private dress(theme: Theme, objects: ObjectLayer, space: SpaceScene): Layers {
    const colours = COLOURS[theme];
    this.layers?.overlay.destroy();
    this.layers?.search.destroy();
    this.layers?.deaths.destroy();
    this.layers?.lost.destroy();
    this.layers?.onion.destroy();
    this.layers?.way.destroy();
    this.layers?.race.destroy();
    this.layers?.astronaut.destroy();
    objects.clear();
    drawTextures(this.textures, theme);
    space.dress(theme);
    return {
      theme,
      overlay: new OverlayLayer(this, colours),
      search: new SearchLayer(this, colours),
      deaths: new DeathLayer(this, colours),
      lost: new LostLayer(this, colours),
      onion: new OnionLayer(this, colours),
      way: new WayLayer(this, colours),
      race: new RaceLayer(this, theme, colours),
      astronaut: new AstronautLayer(this, colours),
    };
  }
}

/**
 * The one Phaser game of the page. It is never destroyed: Phaser would return its canvas, which is opaque, to the pool on which
 * the next game draws pictures.
 */
export interface Stage {
  /**
   * Puts the canvas into an element.
   * @param picture read once per frame
   * @returns removes it again; nothing is drawn until it is mounted elsewhere
   */
  mount(parent: HTMLElement, picture: () => Picture): () => void;
  /** The canvas is empty until the next frame, which the view of another size calls for. */
  resize(width: number, height: number): void;
}

/** Skips frames in which nothing has changed. */
class PacedGame extends Game {
  constructor(
    config: Types.Core.GameConfig,
    private readonly level: LevelScene,
  ) {
    super(config);
  }

  override step(time: number, delta: number): void {
    if (this.level.isDue(time)) super.step(time, delta);
  }
}

/** Phaser only draws: its physics, sound and input are off, as the engine, the editor and the user move things. */
export function createStage(renderer: RendererName): Stage {
  const level = new LevelScene();
  const canvas = document.createElement('canvas');
  const game = new PacedGame(
    {
      type: renderer === 'webgl' ? WEBGL : CANVAS,
      // `mount` puts it into the page
      canvas,
      parent: null,
      width: 1,
      height: 1,
      // The owner of the stage reports size changes. If Phaser looked for them itself, it would make the browser lay out the page
      // in the middle of a frame.
      scale: { mode: Scale.NONE, resizeInterval: Number.POSITIVE_INFINITY },
      banner: false,
      audio: { noAudio: true },
      input: { keyboard: false, mouse: false, touch: false, gamepad: false },
      render: { antialias: true },
      backgroundColor: COLOURS.dark.space,
      scene: [new SpaceScene(), level],
      callbacks: {
        // only the first scene of the list starts by itself
        postBoot: (booted) => booted.scene.start('level'),
      },
    },
    level,
  );
  return {
    mount(parent, picture) {
      parent.append(canvas);
      level.show(picture);
      // before the game runs, there is nothing to wake: it starts by itself
      if (game.isRunning) game.loop.wake();
      return () => {
        canvas.remove();
        level.show(null);
        game.loop.sleep();
      };
    },
    resize: (width, height) => game.scale.resize(Math.max(1, width), Math.max(1, height)),
  };
}
