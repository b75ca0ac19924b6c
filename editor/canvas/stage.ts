import { CANVAS, Game, Scale, Scene, WEBGL } from 'phaser';
import type { LevelFile } from '../../schema/index.ts';
import type { ObjectKey } from '../document/index.ts';
import type { LiveProof } from '../proof/index.ts';
import type { Layer } from '../session/index.ts';
import type { CanvasState } from './canvas-state.ts';
import { COLOURS, type Colours } from './colours.ts';
import { AstronautLayer } from './layers/astronaut-layer.ts';
import { ObjectLayer } from './layers/object-layer.ts';
import { OverlayLayer } from './layers/overlay-layer.ts';
import { SearchLayer, type SearchPicture } from './layers/search-layer.ts';
import { SpaceScene } from './layers/space-scene.ts';
import { type Ghost, WayLayer } from './layers/way-layer.ts';
import type { Pose } from './pose.ts';
import { drawTextures } from './textures/index.ts';

/** Everything that a frame shows. Parts that are the same object as in the last frame are not drawn anew. */
export interface Picture {
  readonly file: LevelFile;
  readonly proof: LiveProof;
  readonly canvas: CanvasState;
  readonly selected: readonly ObjectKey[];
  readonly hovered: ObjectKey | null;
  readonly layers: Readonly<Record<Layer, boolean>>;
  /** px; null: no grid */
  readonly grid: number | null;
  readonly ghosts: readonly Ghost[];
  readonly search: SearchPicture;
  readonly pose: Pose;
  readonly editing: boolean;
  readonly theme: 'dark' | 'light';
  /** Whether little motion is wanted. */
  readonly calm: boolean;
}

/** Layers of one theme. */
interface Layers {
  readonly colours: Colours;
  readonly overlay: OverlayLayer;
  readonly search: SearchLayer;
  readonly way: WayLayer;
  readonly astronaut: AstronautLayer;
}

/** Phaser draws what it is given, and owns nothing. */
class LevelScene extends Scene {
  private objects: ObjectLayer | null = null;
  private layers: Layers | null = null;
  private last: Picture | null = null;
  private ready = false;

  constructor(private readonly picture: () => Picture | null) {
    super('level');
  }

  create(): void {
    this.objects = new ObjectLayer(this);
    this.ready = true;
  }

  override update(time: number): void {
    const picture = this.picture();
    if (!this.ready || picture === null || this.objects === null) return;
    const last = this.last;
    const space = this.scene.get('space') as SpaceScene;
    if (this.layers === null || last?.theme !== picture.theme) this.wear(picture.theme, this.objects, space);
    const { overlay, search, way, astronaut } = this.layers as Layers;
    const fresh = last === null || last.theme !== picture.theme;
    const { view } = picture.canvas;
    if (fresh || last.canvas.view !== view) {
      this.cameras.main.setZoom(view.zoom).centerOn(view.x, view.y);
      space.show(view);
    }
    this.objects.show(picture.file);
    const zoomed = fresh || last.canvas.view.zoom !== view.zoom;
    const same = (...names: readonly (keyof Picture)[]) => !fresh && names.every((name) => last[name] === picture[name]);
    if (!same('file', 'canvas', 'selected', 'hovered', 'layers', 'grid', 'editing')) overlay.show(picture);
    if (zoomed || !same('proof', 'ghosts', 'layers')) way.show({ ...picture, zoom: view.zoom });
    if (zoomed || !same('search', 'layers')) search.show(picture.search, picture.layers.heatMap, view.zoom);
    if (zoomed || !same('file', 'pose')) this.objects.pose(picture.pose, view.zoom);
    const seconds = time / 1000;
    if (!picture.calm) this.objects.animate(seconds, view.zoom);
    astronaut.show(picture.pose, picture.file.astronaut, seconds, picture.calm);
    this.last = picture;
  }

  private wear(theme: Picture['theme'], objects: ObjectLayer, space: SpaceScene): void {
    const colours = COLOURS[theme];
    this.layers?.overlay.destroy();
    this.layers?.search.destroy();
    this.layers?.way.destroy();
    this.layers?.astronaut.destroy();
    objects.clear();
    drawTextures(this.textures, colours);
    space.build(colours);
    this.layers = {
      colours,
      overlay: new OverlayLayer(this, colours),
      search: new SearchLayer(this, colours),
      way: new WayLayer(this, colours),
      astronaut: new AstronautLayer(this, colours),
    };
  }
}

/** Names by which a browser says that the processor stands in for a graphics card. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** Whether a graphics card draws: where a processor would have to stand in for it, a plain canvas is many times faster. */
function hasGraphicsCard(): boolean {
  const context = document.createElement('canvas').getContext('webgl', { failIfMajorPerformanceCaveat: true });
  if (context === null) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return !SOFTWARE.test(renderer);
}

export interface Stage {
  resize(width: number, height: number): void;
  /** What is on the screen, as a PNG. */
  snapshot(): Promise<Blob>;
  destroy(): void;
}

/**
 * The one Phaser game of the page. Its physics, sound and input are off: the engine, the editor and the person move things, it draws.
 * @param picture asked once a frame
 */
export function createStage(parent: HTMLElement, picture: () => Picture | null): Stage {
  const game = new Game({
    type: hasGraphicsCard() ? WEBGL : CANVAS,
    parent,
    width: Math.max(1, parent.clientWidth),
    height: Math.max(1, parent.clientHeight),
    // who made the stage says when its size changes: looking for itself, Phaser would make the browser lay out the page in the middle of a frame
    scale: { mode: Scale.NONE, resizeInterval: Number.POSITIVE_INFINITY },
    banner: false,
    audio: { noAudio: true },
    input: { keyboard: false, mouse: false, touch: false, gamepad: false },
    render: { antialias: true },
    backgroundColor: COLOURS.dark.space,
    scene: [new SpaceScene(), new LevelScene(picture)],
    callbacks: {
      // only the first scene of a list starts by itself
      postBoot: (booted) => booted.scene.start('level'),
    },
  });
  return {
    resize: (width, height) => game.scale.resize(Math.max(1, width), Math.max(1, height)),
    snapshot: () =>
      new Promise((resolve, reject) => {
        game.events.once('postrender', () =>
          game.canvas.toBlob(
            (blob) => (blob === null ? reject(new Error('the browser made no picture')) : resolve(blob)),
            'image/png',
          ),
        );
      }),
    destroy: () => game.destroy(true),
  };
}
