import type { GameObjects } from 'phaser';
import { colourNumber, STAR_TILE } from '../../drawing/index.ts';
import type { Skin, SkinStage } from '../skin.ts';
import { imageOf } from './pieces.ts';

/** the share of the view's motion that a layer of stars follows: less for the farther one */
const PARALLAX = { far: 0.08, near: 0.22 } as const;
/** the share of the view's zoom that stars follow */
const ZOOM_SHARE = 0.15;
const HAZE = [
  { scale: 9, across: 0.2, down: 0.25 },
  { scale: 7, across: 0.8, down: 0.7 },
  { scale: 5, across: 0.55, down: 0.1 },
] as const;

/** A layer of stars: as many images of a seamless tile as are needed. */
class Stars {
  private readonly tiles: GameObjects.Image[] = [];

  constructor(
    private readonly stage: SkinStage,
    private readonly into: GameObjects.Container,
    private readonly name: 'far' | 'near',
  ) {}

  show(): void {
    const { width, height, view } = this.stage;
    const share = PARALLAX[this.name];
    const scale = Math.min(2, Math.max(0.6, 1 + ZOOM_SHARE * (view.zoom - 1)));
    const size = STAR_TILE * scale;
    const fromX = -(((view.x * share) % size) + size) % size;
    const fromY = -(((view.y * share) % size) + size) % size;
    let used = 0;
    for (let y = fromY; y < height; y += size) {
      for (let x = fromX; x < width; x += size) this.tile(used++).setPosition(x, y).setScale(scale).setVisible(true);
    }
    for (let i = used; i < this.tiles.length; i++) this.tiles[i].setVisible(false);
  }

  private tile(i: number): GameObjects.Image {
    if (i === this.tiles.length) {
      const made = imageOf(this.stage, `stars-${this.name}`, 0).setOrigin(0);
      this.into.add(made);
      this.tiles.push(made);
    }
    return this.tiles[i];
  }
}

/** Space: haze, and two layers of stars that follow the view a little. */
export const background: Skin['background'] = (stage) => {
  const { scene, colours } = stage;
  const floor = scene.add.rectangle(0, 0, 1, 1, colourNumber(colours.space)).setOrigin(0);
  const haze = HAZE.map(({ scale }) => imageOf(stage, 'haze', 0).setScale(scale));
  const container = scene.add.container(0, 0, [floor, ...haze]);
  const far = new Stars(stage, container, 'far');
  const near = new Stars(stage, container, 'near');
  // what the last frame showed: space stands still while the view does
  const shown = { x: 0, y: 0, zoom: 0, width: 0, height: 0 };
  return {
    objects: [container],
    update() {
      const { width, height, view } = stage;
      const { x, y, zoom } = view;
      if (x === shown.x && y === shown.y && zoom === shown.zoom && width === shown.width && height === shown.height) return;
      shown.x = x;
      shown.y = y;
      shown.zoom = zoom;
      shown.width = width;
      shown.height = height;
      floor.setScale(width, height);
      for (let i = 0; i < HAZE.length; i++) {
        haze[i].setPosition(width * HAZE[i].across - 0.03 * x, height * HAZE[i].down - 0.03 * y);
      }
      far.show();
      near.show();
    },
  };
};
