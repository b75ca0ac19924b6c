import { type GameObjects, Scene } from 'phaser';
import { STAR_TILE } from '../../../phaser/index.ts';
import { COLOURS, colourNumber, type Theme } from '../colours.ts';
import type { View } from '../view.ts';

/** the share of the view's motion that a layer of stars follows: less for the farther one */
const PARALLAX = { far: 0.08, near: 0.22 } as const;
/** the share of the view's zoom that stars follow */
const ZOOM_SHARE = 0.15;

/** Phaser keeps copies of the tiles, so each theme has its own, which is never redrawn. */
export const starsOf = (theme: Theme, layer: 'far' | 'near'): string => `stars-${layer}-${theme}`;

/** The stars behind the level; a scene of its own, as it neither zooms nor moves with the level. */
export class SpaceScene extends Scene {
  private far: GameObjects.TileSprite | null = null;
  private near: GameObjects.TileSprite | null = null;
  private haze: GameObjects.Image[] = [];

  constructor() {
    super('space');
  }

  /**
   * Applies a theme whose textures exist. Nothing is created twice: when a tile is destroyed, Phaser releases its canvases only
   * partly.
   */
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
