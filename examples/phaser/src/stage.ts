import { CANVAS, Game, Scale, Scene, WEBGL } from 'phaser';

/** Canvas pixels per CSS pixel, at most: finer ones are hard to see, and cost a phone its battery. */
const MOST_RATIO = 2;
/** Canvas pixels at most. */
const MOST_PIXELS = 2_600_000;

/** The scene of the level that is played. What happens in it is up to the runner and the level screen. */
export class PlayScene extends Scene {
  /** Called once per frame, after the runner. */
  onFrame: (() => void) | null = null;

  constructor(private readonly onReady: (scene: PlayScene) => void) {
    super('play');
  }

  create(): void {
    this.onReady(this);
  }

  override update(): void {
    this.onFrame?.();
  }
}

export interface Stage {
  readonly scene: Promise<PlayScene>;
  /** Canvas pixels per CSS pixel. */
  readonly ratio: number;
  /** Fits the canvas to its element. */
  resize(): void;
  /** Frames are drawn while the stage is awake only. */
  wake(): void;
  sleep(): void;
}

/** Names by which browsers report drawing in software. */
const SOFTWARE = /swiftshader|llvmpipe|software|basic render/i;

/** Whether a graphics card draws WebGL. In software it is many times slower than the 2D canvas. */
function hasGraphicsCard(): boolean {
  const context = document.createElement('canvas').getContext('webgl', { failIfMajorPerformanceCaveat: true });
  if (context === null) return false;
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const renderer = String(context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  context.getExtension('WEBGL_lose_context')?.loseContext();
  return !SOFTWARE.test(renderer);
}

/**
 * Starts Phaser in an element. One game serves all levels.
 * @param renderer `webgl` or `canvas`; null: what is faster
 */
export function createStage(parent: HTMLElement, renderer: string | null): Stage {
  const usesWebgl = renderer === 'webgl' || (renderer !== 'canvas' && hasGraphicsCard());
  let ratio = 1;
  const size = () => {
    const width = Math.max(1, parent.clientWidth);
    const height = Math.max(1, parent.clientHeight);
    ratio = Math.min(MOST_RATIO, window.devicePixelRatio || 1, Math.sqrt(MOST_PIXELS / (width * height)));
    return { width: Math.round(width * ratio), height: Math.round(height * ratio) };
  };
  let isReady: (scene: PlayScene) => void = () => {};
  const scene = new Promise<PlayScene>((resolve) => {
    isReady = resolve;
  });
  const game = new Game({
    type: usesWebgl ? WEBGL : CANVAS,
    parent,
    ...size(),
    scale: { mode: Scale.NONE, zoom: 1 / ratio },
    backgroundColor: '#0a0d15',
    banner: false,
    audio: { noAudio: true },
    disableContextMenu: true,
    input: { gamepad: true, activePointers: 2 },
    scene: new PlayScene(isReady),
  });
  return {
    scene,
    get ratio() {
      return ratio;
    },
    resize() {
      const { width, height } = size();
      game.scale.setZoom(1 / ratio);
      game.scale.resize(width, height);
    },
    wake: () => game.loop.wake(),
    sleep: () => game.loop.sleep(),
  };
}
