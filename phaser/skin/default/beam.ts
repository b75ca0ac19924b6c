import type { GameObjects } from 'phaser';
import { TEXTURE_UNIT } from '../../drawing/index.ts';
import type { Skin, SkinStage } from '../skin.ts';
import { colouredImage } from './pieces.ts';

const GRAINS = 14;
/** px across, with its glow */
const WIDTH = 12;
const SIDE = 2 * TEXTURE_UNIT;

/** A beam from one place to another. */
export class Beam {
  readonly image: GameObjects.Image;

  constructor(stage: SkinStage, depth: number, colour: string, alpha: number) {
    this.image = colouredImage(stage, 'beam', colour, depth).setOrigin(0, 0.5).setAlpha(alpha).setVisible(false);
  }

  hide(): void {
    this.image.setVisible(false);
  }

  show(x: number, y: number, toX: number, toY: number, width: number): void {
    const dx = toX - x;
    const dy = toY - y;
    this.image
      .setVisible(true)
      .setPosition(x, y)
      .setRotation(Math.atan2(dy, dx))
      .setScale(Math.sqrt(dx * dx + dy * dy) / SIDE, width / SIDE);
  }
}

/** The asteroid that the gun would pull her towards: the nearest, the first one of equals; -1 without asteroids. */
function nearest({ pose, asteroids }: SkinStage): number {
  let best = -1;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; 2 * i < asteroids.length; i++) {
    const dx = asteroids[2 * i] - pose[0];
    const dy = asteroids[2 * i + 1] - pose[1];
    const distance = dx * dx + dy * dy;
    if (distance >= least) continue;
    least = distance;
    best = i;
  }
  return best;
}

/** The beam with grains of light that run along it, and a ring around the asteroid that the gun pulls towards, or would. */
export const beam: Skin['beam'] = (stage) => {
  const { player, level, colours } = stage;
  const light = new Beam(stage, 8, colours.beam, 1);
  const grains = Array.from({ length: GRAINS }, () => colouredImage(stage, 'spark', colours.beam, 8.1).setVisible(false));
  const mark = colouredImage(stage, 'mark', colours.beam, 7.2).setVisible(false);

  const aim = (target: number) => {
    const { asteroids, time } = stage;
    const { radius } = level.asteroids[target];
    const held = player.target !== null;
    mark
      .setVisible(true)
      .setPosition(asteroids[2 * target], asteroids[2 * target + 1])
      .setScale((radius + 5 + (held ? Math.sin(9 * time) : 0)) / (0.95 * TEXTURE_UNIT))
      .setAlpha(held ? 0.9 : 0.32);
  };
  return {
    objects: [mark, light.image, ...grains],
    update() {
      const { pose, asteroids, time } = stage;
      const { target, ending } = player;
      const aimed = ending === null ? (target ?? nearest(stage)) : -1;
      if (aimed === -1) mark.setVisible(false);
      else aim(aimed);
      const pulls = target !== null && ending === null;
      for (let i = 0; i < GRAINS; i++) grains[i].setVisible(pulls);
      if (!pulls) {
        light.hide();
        return;
      }
      const x = pose[0];
      const y = pose[1];
      const toX = asteroids[2 * target];
      const toY = asteroids[2 * target + 1];
      light.show(x, y, toX, toY, WIDTH + 1.5 * Math.sin(23 * time));
      const dx = toX - x;
      const dy = toY - y;
      const length = Math.max(1, Math.sqrt(dx * dx + dy * dy));
      for (let i = 0; i < GRAINS; i++) {
        // grains run from the asteroid to her and sway around the beam
        const share = 1 - ((time * 0.9 + i / GRAINS) % 1);
        const sway = (4 * Math.sin(17 * share + 2.4 * i + 6 * time) * (1 - share)) / length;
        grains[i]
          .setPosition(x + dx * share - dy * sway, y + dy * share + dx * sway)
          .setScale(0.035 + 0.01 * (i % 3))
          .setAlpha(0.35 + 0.65 * share);
      }
    },
  };
};
