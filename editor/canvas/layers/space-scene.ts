import { type GameObjects, Scene } from 'phaser';
import { COLOURS, colourNumber, type Theme } from '../colours.ts';
import { STAR_TILE, starsOf } from '../textures/index.ts';
import type { View } from '../view.ts';

/** How much of the view's way a layer of stars goes along: the farther, the less. */
const PARALLAX = { far: 0.08, near: 0.22 } as const;
/** Stars grow with the view's zoom, but only a little. */
const ZOOM_SHARE = 0.15;

/** The stars behind the level; a scene of its own, since it neither zooms nor moves like the level. */
export class SpaceScene extends Scene {
  private far: GameObjects.TileSprite | null = null;
  private near: GameObjects.TileSprite | null = null;
  private haze: GameObjects.Image[] = [];

  constructor() {
    super('space');
  }

  /** Wears a theme whose textures are drawn. Nothing is made twice: Phaser forgets the canvases of a tile that is destroyed only halfway. */
  dress(theme: Theme): void {
    this.cameras.main.setBackgroundColor(colourNumber(COLOURS[theme].space));
    if (this.haze.length === 0) this.haze = [0, 1, 2].map((i) => this.add.image(0, 0, 'haze').setScale(9 - 2 * i));
    const [far, near] = [starsOf(theme, 'far'), starsOf(theme, 'near')];
    this.far = this.far?.setTexture(far) ?? this.add.tileSprite(0, 0, STAR_TILE, STAR_TILE, far).setOrigin(0);
    this.near = this.near?.setTexture(near) ?? this.add.tileSprite(0, 0, STAR_TILE, STAR_TILE, near).setOrigin(0);
  }

  show({ x, y, zoom, width, height }: View): void {
    if (this.far === null || this.near === null) return;
    const grown = 1 + ZOOM_SHARE * (zoom - 1);
    for (const [tile, share] of [
      [this.far, PARALLAX.far],
      [this.near, PARALLAX.near],
    ] as const) {
      tile.setSize(width, height);
      tile.setTileScale(Math.min(2, Math.max(0.6, grown)));
      tile.setTilePosition(x * share, y * share);
    }
    const places = [
      [0.2, 0.25],
      [0.8, 0.7],
      [0.55, 0.1],
    ] as const;
    for (const [i, [across, down]] of places.entries()) {
      this.haze[i]?.setPosition(width * across - 0.03 * x, height * down - 0.03 * y);
    }
  }
}
