import type { Scene } from 'phaser';
import { STATE_SIZE } from '../../engine/index.ts';
import type { Player } from '../../game/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { GAME_COLOURS, type GameColours } from '../drawing/index.ts';
import { type SkinStage, skinTexture } from '../skin/index.ts';
import type { LevelView } from './view.ts';

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
