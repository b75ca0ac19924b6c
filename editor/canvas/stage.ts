import { CANVAS, Game, Scale, Scene, type Types, WEBGL } from 'phaser';
import { drawStarTiles, drawTextures } from '../../phaser/index.ts';
import type { Editor } from '../core/context/index.ts';
import { COLOURS, type Theme } from './colours.ts';
import { AstronautLayer, ObjectLayer, OverlayLayer, SpaceScene, starsOf, WayLayer } from './layers/index.ts';
import type { Drawing, DrawnPart } from './part.ts';
import { isFrameDue, type Picture } from './picture.ts';
import { type ChosenRenderer, chooseRenderer, offersWebgl, type RendererName } from './renderer.ts';

/** The layers, drawn in one theme. */
interface Layers {
  readonly theme: Theme;
  readonly overlay: OverlayLayer;
  readonly way: WayLayer;
  readonly astronaut: AstronautLayer;
  /** What features of the page have drawn, one for each drawn part. */
  readonly parts: readonly Drawing<unknown>[];
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

  /** @param drawnParts what features of the page draw into every level */
  constructor(private readonly drawnParts: readonly DrawnPart[]) {
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
    const { overlay, way, astronaut, parts } = this.layers as Layers;
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
    const frame = { zoom: view.zoom, her: picture.her };
    for (const [i, part] of parts.entries()) {
      if (zoomed || !same('her') || last.parts[i] !== picture.parts[i]) part.show(picture.parts[i], frame);
    }
    if (zoomed || !same('file', 'pose', 'editing')) objects.pose(picture.pose, view.zoom);
    const seconds = time / 1000;
    if (!picture.calm) objects.animate(seconds, view.zoom);
    astronaut.show(picture.pose, picture.file.astronaut, picture.her, seconds, picture.calm);
    this.last = picture;
  }

  private dress(theme: Theme, objects: ObjectLayer, space: SpaceScene): Layers {
    const colours = COLOURS[theme];
    const { overlay, way, astronaut, parts } = this.layers ?? {};
    for (const layer of [overlay, way, astronaut, ...(parts ?? [])]) layer?.destroy();
    objects.clear();
    // textures of the previous theme are drawn again in place, so that images that use them stay valid
    drawTextures(this.textures, theme, (name) => name);
    drawStarTiles(this.textures, theme, starsOf(theme, 'far'), starsOf(theme, 'near'));
    space.dress(theme);
    return {
      theme,
      overlay: new OverlayLayer(this, colours),
      way: new WayLayer(this, colours),
      astronaut: new AstronautLayer(this, colours),
      parts: this.drawnParts.map(({ draw }) => draw(this, theme)),
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

/**
 * Phaser only draws: its physics, sound and input are off, as the engine, the editor and the user move things.
 * @param drawn what features of the page draw into every level
 */
function createStage(renderer: RendererName, drawn: readonly DrawnPart[]): Stage {
  const level = new LevelScene(drawn);
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

interface PageStage {
  readonly stage: Stage;
  readonly renderer: ChosenRenderer;
}

/** one stage per editor, for as long as the page lives */
const stages = new WeakMap<Editor, PageStage>();

/**
 * The stage of the page, created when the first level is shown. Shows a notice if it can't use the requested renderer.
 * @param drawn what features of the page draw; the same at every call
 */
export function stageOf(editor: Editor, drawn: readonly DrawnPart[]): Stage {
  const known = stages.get(editor);
  if (known !== undefined) return known.stage;
  const { settings, notices } = editor;
  const renderer = chooseRenderer(settings.getState().renderer, window.location.search, (need) => offersWebgl(document, need));
  if (renderer.complaint !== null) notices.show('warning', renderer.complaint, { topic: 'renderer' });
  const stage = createStage(renderer.name, drawn);
  stages.set(editor, { stage, renderer });
  return stage;
}

/** The renderer of this page; null before anything is drawn. */
export const rendererOf = (editor: Editor): ChosenRenderer | null => stages.get(editor)?.renderer ?? null;
