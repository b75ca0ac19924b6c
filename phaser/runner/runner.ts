import type { Scene } from 'phaser';
import type { Scene as Compiled } from '../../engine/index.ts';
import { createPlayer, type Player } from '../../game/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { GunInput } from '../input/index.ts';
import { DEFAULT_SKIN, type View } from '../skin/index.ts';
import { Figures, Stage } from './figures.ts';
import type { RunnerOptions } from './options.ts';
import { requireLevel, requireScene } from './require.ts';
import { LevelView } from './view.ts';

/** ms from a death to the next attempt if the options name none */
const RESTART_AFTER = 700;
/** ms after a death in which a press still belongs to the last attempt */
const GRACE = 200;
/** longest frame that decorations count, ms */
const MOST_SHOWN = 100;

/** A level that is played in a Phaser scene. */
export interface Runner {
  /** The attempt that is played; another object after {@link Runner.load}. */
  readonly player: Player;
  /** What is visible. */
  readonly view: View;
  /** Whether the game has paused it. A hidden page stops it, too, and is not counted here. */
  readonly paused: boolean;
  /** Whether it has ended, by itself or with its scene. */
  readonly destroyed: boolean;
  /**
   * Plays another level. The present one stays if this fails.
   *
   * @param level - a level, or a scene that `compile` made of one
   * @param options - options that differ from those so far; replay, from and ghosts are only taken from here
   * @throws {TypeError} when `level` is not a level
   */
  load(level: Level | Compiled, options?: RunnerOptions): void;
  /** Begins again at once. */
  restart(): void;
  /** Stops the time of the level, for a menu for instance. */
  pause(): void;
  /** Goes on after {@link Runner.pause}. */
  resume(): void;
  /** Removes everything that it has added to the scene. The scene's shutdown does so by itself. */
  destroy(): void;
}

interface Loaded {
  readonly player: Player;
  readonly stage: Stage;
  readonly view: LevelView;
  readonly figures: Figures;
  readonly options: RunnerOptions;
}

/** See {@link createRunner}. */
class LevelRunner implements Runner {
  paused = false;
  private isHidden = false;
  destroyed = false;
  private lastTime = Number.NaN;
  /** ms since the end of the play */
  private ended = 0;
  private lastTick = 0;
  private hadEnded = false;
  private readonly input: GunInput;
  private loaded: Loaded;

  constructor(
    private readonly scene: Scene,
    level: Level | Compiled,
    options: RunnerOptions,
  ) {
    this.loaded = this.make(level, options);
    this.input = new GunInput(scene, options.input ?? {}, {
      onButton: (down) => this.onButton(down),
      onVisible: (visible) => this.onVisible(visible),
      covers: (x, y) => this.covers(x, y),
    });
    const { events } = scene.sys;
    events.on('update', this.update, this);
    events.once('shutdown', this.destroy, this);
    events.once('destroy', this.destroy, this);
    events.on('resume', this.forgetTime, this);
    events.on('wake', this.forgetTime, this);
    this.show();
  }

  get player(): Player {
    return this.loaded.player;
  }

  get view(): View {
    return this.loaded.view;
  }

  load(level: Level | Compiled, options: RunnerOptions = {}): void {
    if (this.destroyed)
      throw new Error('Runner.load: expected a runner in use, found one that is destroyed. Create another one.');
    requireLevel('Runner.load', level);
    const { replay: _, from: __, ghosts: ___, ...kept } = this.loaded.options;
    const old = this.loaded;
    this.loaded = this.make(level, { ...kept, ...options });
    old.figures.destroy();
    this.begin();
    this.show();
  }

  private make(level: Level | Compiled, options: RunnerOptions): Loaded {
    let made: Loaded | null = null;
    const player = createPlayer(level, {
      ...options,
      onEvent: (event) => {
        if (made === null || this.loaded !== made) return;
        made.figures.onEvent(event);
        options.onEvent?.(event);
      },
      onEnd: (ending) => {
        if (made !== null && this.loaded === made) options.onEnd?.(ending);
      },
    });
    const { camera = 'fit', depth = 0, skin } = options;
    const view = new LevelView(player.scene, camera);
    const stage = new Stage(this.scene, player, view);
    const figures = new Figures(stage, { ...DEFAULT_SKIN, ...skin }, depth, camera !== 'none');
    made = { player, stage, view, figures, options };
    this.layOut(made);
    return made;
  }

  /** Whether a press at a place of the canvas is on what this runner shows. */
  private covers(x: number, y: number): boolean {
    const { main } = this.scene.cameras;
    const [inX, inY] = [x - main.x, y - main.y];
    if (inX < 0 || inX > main.width || inY < 0 || inY > main.height) return false;
    const { stage, view, options } = this.loaded;
    if (options.area === undefined) return true;
    const [atX, atY] = [stage.left + inX / main.zoom, stage.top + inY / main.zoom];
    return atX >= view.left && atX <= view.left + view.width && atY >= view.top && atY <= view.top + view.height;
  }

  /** Takes the size of the canvas. Called every frame, as the scene's camera has no event for its size. */
  private layOut({ view, stage, options: { area, camera } }: Loaded): void {
    const { width, height, zoom, scrollX, scrollY } = this.scene.cameras.main;
    stage.width = width / zoom;
    stage.height = height / zoom;
    const isFixed = camera !== 'none';
    // the camera zooms around its middle
    stage.left = (isFixed ? 0 : scrollX) + (width - stage.width) / 2;
    stage.top = (isFixed ? 0 : scrollY) + (height - stage.height) / 2;
    const part = area?.();
    const isOther = view.place(
      stage.left + (part?.x ?? 0) / zoom,
      stage.top + (part?.y ?? 0) / zoom,
      (part?.width ?? width) / zoom,
      (part?.height ?? height) / zoom,
    );
    if (isOther) view.jump(stage.pose);
  }

  private forgetTime(): void {
    this.lastTime = Number.NaN;
  }

  private onVisible(visible: boolean): void {
    this.isHidden = !visible;
    this.forgetTime();
  }

  private onButton(down: boolean): void {
    if (this.isStopped) return;
    const { player } = this;
    if (down && this.restartsAfter !== null && this.ended >= GRACE) this.restart();
    else if (down) player.press();
    else player.release();
  }

  private get isStopped(): boolean {
    return this.paused || this.isHidden || this.destroyed;
  }

  /** ms from the end of the play to the next attempt; null: none follows by itself. */
  private get restartsAfter(): number | null {
    const { ending } = this.player;
    const { restartAfter = RESTART_AFTER } = this.loaded.options;
    return ending === null || ending.outcome === 'completed' ? null : restartAfter;
  }

  restart(): void {
    if (this.destroyed) return;
    this.player.restart();
    this.begin();
    this.loaded.options.onRestart?.();
  }

  /** Starts to show an attempt. */
  private begin(): void {
    const { player, stage, figures } = this.loaded;
    this.ended = 0;
    this.lastTick = player.tick;
    this.hadEnded = false;
    stage.read();
    figures.onRestart();
    // a button that is down holds the gun of this attempt, too
    if (this.input.down && !this.isStopped) player.press();
  }

  /** The game may restart the player itself. */
  private noticeRestart(): void {
    const { tick, ending } = this.player;
    const isOther = tick < this.lastTick || (this.hadEnded && ending === null);
    this.lastTick = tick;
    this.hadEnded = ending !== null;
    if (isOther) this.begin();
  }

  pause(): void {
    this.paused = true;
  }

  resume(): void {
    this.paused = false;
    if (this.isStopped) return;
    // the button may have changed meanwhile
    if (this.input.down) this.player.press();
    else this.player.release();
  }

  /** @param time ms, by the clock of the game's frames; Phaser's `delta` is smoothed and capped */
  private update(time: number): void {
    const passed = Number.isNaN(this.lastTime) ? 0 : Math.max(0, time - this.lastTime);
    this.lastTime = time;
    this.input.look();
    const ms = this.isStopped ? 0 : passed;
    if (!this.isStopped) this.advance(ms);
    if (this.destroyed) return;
    this.loaded.stage.pass(Math.min(ms, MOST_SHOWN));
    this.show();
  }

  private advance(ms: number): void {
    this.noticeRestart();
    if (this.player.ending === null) {
      const { player } = this;
      player.advance(ms);
      if (this.destroyed || player !== this.player) return;
      this.noticeRestart();
      return;
    }
    this.ended += ms;
    const { restartsAfter } = this;
    if (restartsAfter !== null && this.ended >= restartsAfter) this.restart();
  }

  private show(): void {
    const { stage, view, figures } = this.loaded;
    stage.read();
    this.layOut(this.loaded);
    view.follow(stage.pose, stage.seconds);
    figures.update();
  }

  destroy(): void {
    if (this.destroyed) return;
    this.destroyed = true;
    const { events } = this.scene.sys;
    events.off('update', this.update, this);
    events.off('shutdown', this.destroy, this);
    events.off('destroy', this.destroy, this);
    events.off('resume', this.forgetTime, this);
    events.off('wake', this.forgetTime, this);
    this.input.destroy();
    this.loaded.figures.destroy();
  }
}

/**
 * Plays a level in a Phaser scene: shows it, listens to the player, and advances with the scene. It ends with the scene.
 *
 * @param scene - the scene; call this in its `create`
 * @param level - a level, or a scene that `compile` made of one
 * @param options - how it looks, what plays it, and what is told of it
 * @returns the runner
 * @throws {TypeError} when `scene` is not a scene of Phaser 3.90 to 4.x, or `level` is not a level
 *
 * @example
 * ```ts
 * class Play extends Phaser.Scene {
 *   create() {
 *     createRunner(this, level, { onEnd: ({ outcome }) => outcome === 'completed' && this.scene.start('menu') });
 *   }
 * }
 * ```
 */
export function createRunner(scene: Scene, level: Level | Compiled, options: RunnerOptions = {}): Runner {
  requireScene('createRunner', scene);
  requireLevel('createRunner', level);
  return new LevelRunner(scene, level, options);
}
