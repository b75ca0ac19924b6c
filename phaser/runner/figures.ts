import type { GameObjects, Scene } from 'phaser';
import { STATE_SIZE } from '../../engine/index.ts';
import type { Ghost, PlayEvent, Player } from '../../game/index.ts';
import { type Level, OBJECT_KINDS, objectsIn } from '../../schema/basics/index.ts';
import { GAME_COLOURS, type GameColours } from '../drawing/index.ts';
import { type Draw, type Figure, type Skin, type SkinStage, skinTexture } from '../skin/index.ts';
import type { LevelView } from './view.ts';

const objectsOf = (figures: readonly Figure[]): GameObjects.GameObject[] => figures.flatMap(({ objects }) => [...objects]);

/** The figures of a level, in two containers: space in px of the canvas, the level in px of the level. */
export class Figures {
  private readonly root: GameObjects.Container;
  private readonly space: GameObjects.Container;
  private readonly level: GameObjects.Container;
  private readonly figures: Figure[] = [];
  private ghosts: readonly Ghost[] | null = null;
  private ghostFigures: Figure[] = [];
  private isDestroyed = false;

  constructor(
    private readonly stage: Stage,
    private readonly skin: Skin,
    depth: number,
    isFixed: boolean,
  ) {
    const { scene, level } = stage;
    this.space = scene.add.container();
    this.level = scene.add.container();
    this.root = scene.add.container(0, 0, [this.space, this.level]).setDepth(depth);
    // a view of its own does not move with the scene's camera
    if (isFixed) this.root.setScrollFactor(0);
    try {
      this.space.add(objectsOf(this.draw(skin.background, [level]))).sort('depth');
      const drawn = [
        ...OBJECT_KINDS.flatMap((kind) => this.draw(skin[kind] as Draw<object>, objectsIn(level, kind))),
        ...[skin.trail, skin.beam, skin.effects].flatMap((draw) => this.draw(draw, [level])),
      ];
      this.level.add(objectsOf(drawn)).sort('depth');
      this.showGhosts();
    } catch (error) {
      this.destroy();
      throw error;
    }
  }

  /** @param into receives each figure once it is made, so that it can be removed if the next one fails */
  private draw<T>(draw: Draw<T>, objects: readonly T[], into: Figure[] = this.figures): Figure[] {
    const from = into.length;
    for (const [i, object] of objects.entries()) {
      const figure = draw(this.stage, object, i);
      if (figure !== null) into.push(figure);
    }
    return into.slice(from);
  }

  /** Makes figures for the ghosts of the attempt, unless they have theirs. */
  private showGhosts(): void {
    const { ghosts } = this.stage.player;
    if (ghosts === this.ghosts) return;
    for (const figure of this.ghostFigures) destroyFigure(figure);
    this.ghosts = ghosts;
    this.ghostFigures = [];
    this.draw(this.skin.ghost, ghosts, this.ghostFigures);
    if (this.ghostFigures.length === 0) return;
    this.level.add(objectsOf(this.ghostFigures)).sort('depth');
  }

  /** Shows the present frame. */
  update(): void {
    const { left, top, width, height, x, y, zoom } = this.stage.view;
    this.showGhosts();
    this.space.setPosition(this.stage.left, this.stage.top);
    this.level.setPosition(left + width / 2 - zoom * x, top + height / 2 - zoom * y).setScale(zoom);
    for (let i = 0; i < this.figures.length; i++) this.figures[i].update?.();
    for (let i = 0; i < this.ghostFigures.length; i++) this.ghostFigures[i].update?.();
  }

  onEvent(event: PlayEvent): void {
    for (const figure of this.figures) if (!this.isDestroyed) figure.onEvent?.(event);
  }

  onRestart(): void {
    for (const figure of this.figures) figure.onRestart?.();
    for (const figure of this.ghostFigures) figure.onRestart?.();
  }

  destroy(): void {
    if (this.isDestroyed) return;
    this.isDestroyed = true;
    for (const figure of [...this.figures, ...this.ghostFigures]) destroyFigure(figure);
    // with everything in it
    this.root.destroy();
  }
}

function destroyFigure({ objects, onDestroy }: Figure): void {
  onDestroy?.();
  for (const object of objects) object.destroy();
}

/** What the figures of a level read; written anew every frame. */
export class Stage implements SkinStage {
  readonly colours: GameColours = GAME_COLOURS.dark;
  readonly pose = new Float64Array(STATE_SIZE);
  readonly aliens: Float64Array;
  readonly asteroids: Float64Array;
  /** Upper left corner of what the scene's camera shows, px. */
  left = 0;
  top = 0;
  width = 1;
  height = 1;
  time = 0;
  seconds = 0;

  constructor(
    readonly scene: Scene,
    readonly player: Player,
    readonly view: LevelView,
  ) {
    this.aliens = new Float64Array(3 * player.level.aliens.length);
    this.asteroids = new Float64Array(2 * player.level.asteroids.length);
    this.read();
  }

  get level(): Level {
    return this.player.level;
  }

  texture(name: string): string {
    return skinTexture(this.scene, name);
  }

  /** Reads what is shown now. */
  read(): void {
    const { player } = this;
    player.readPose(this.pose);
    player.readAliens(this.aliens);
    player.readAsteroids(this.asteroids);
  }

  /** Lets time pass. @param ms since the last frame */
  pass(ms: number): void {
    this.seconds = ms / 1000;
    this.time += this.seconds;
  }
}
