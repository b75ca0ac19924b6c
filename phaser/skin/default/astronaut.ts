import type { GameObjects } from 'phaser';
import type { Box } from '../../../engine/index.ts';
import type { Ghost, PlayEnding } from '../../../game/index.ts';
import { TEXTURE_UNIT } from '../../drawing/index.ts';
import type { Skin, SkinStage } from '../skin.ts';
import { colouredTexture } from '../skin-texture.ts';
import { Beam } from './beam.ts';
import { colouredImage, imageOf } from './pieces.ts';

/** px of half the box that her texture is drawn for */
const DRAWN_WIDTH = 10;
const DRAWN_HEIGHT = 16;

/** The scale at which she fits into her box. */
const scaleIn = ({ halfWidth, halfHeight }: Box): number =>
  (Math.min(halfWidth / DRAWN_WIDTH, halfHeight / DRAWN_HEIGHT) * DRAWN_HEIGHT) / TEXTURE_UNIT;

/** How long she takes to vanish, s. */
const VANISHING: Readonly<Record<PlayEnding['outcome'], number>> = { completed: 0.55, collided: 0.06, lost: 1.1, timeout: 1.1 };

/** Shows her as she vanishes. @param seconds since the end */
function vanish(image: GameObjects.Image, { level, pose }: SkinStage, ending: PlayEnding, scale: number, seconds: number): void {
  const left = Math.max(0, 1 - seconds / VANISHING[ending.outcome]);
  image.setVisible(left > 0);
  if (ending.outcome !== 'completed') {
    image.setAlpha(left).setScale(scale * (ending.outcome === 'lost' ? 0.5 + 0.5 * left : 1));
    return;
  }
  // she spirals into the black hole
  const { x, y } = level.blackHole;
  const dx = pose[0] - x;
  const dy = pose[1] - y;
  const turn = 5 * (1 - left);
  const cos = left * Math.cos(turn);
  const sin = left * Math.sin(turn);
  image
    .setPosition(x + cos * dx - sin * dy, y + sin * dx + cos * dy)
    .setRotation(Math.atan2(pose[5], pose[4]) + 2 * turn)
    .setScale(scale * (0.15 + 0.85 * left));
}

export const astronaut: Skin['astronaut'] = (stage) => {
  const { player } = stage;
  const scale = scaleIn(player.scene.box);
  const body = imageOf(stage, 'astronaut', 9);
  let ended = 0;
  return {
    objects: [body],
    update() {
      const { pose } = stage;
      body.setPosition(pose[0], pose[1]).setRotation(Math.atan2(pose[5], pose[4])).setVisible(true).setAlpha(1).setScale(scale);
      ended = player.ending === null ? 0 : ended + stage.seconds;
      if (player.ending !== null) vanish(body, stage, player.ending, scale, ended);
    },
  };
};

/** Colours of ghosts, in their order. */
const GHOSTS = ['#b9a6ff', '#7cf2b0', '#ffc04d', '#ff9de2'];
/** how long a ghost stays after its end, s */
const LINGERS = 0.6;

/** A ghost: she, translucent, with her beam. */
export const ghost: Skin['ghost'] = (stage, one: Ghost, index) => {
  const pose = new Float64Array(stage.pose.length);
  const colour = GHOSTS[index % GHOSTS.length];
  const body = colouredImage(stage, 'astronaut', colour, 7.8).setScale(scaleIn(stage.player.scene.box));
  const light = new Beam(stage, 7.7, colour, 0.35);
  let ended = 0;
  return {
    objects: [light.image, body],
    update() {
      const { asteroids } = stage;
      one.readPose(pose);
      ended = one.ending === null ? 0 : ended + stage.seconds;
      body
        .setPosition(pose[0], pose[1])
        .setRotation(Math.atan2(pose[5], pose[4]))
        .setAlpha(0.42 * Math.max(0, 1 - ended / LINGERS));
      const { target } = one;
      // with recoil its asteroids are elsewhere, and the beam would miss them
      if (target === null || one.ending !== null || stage.level.recoil) light.hide();
      else light.show(pose[0], pose[1], asteroids[2 * target], asteroids[2 * target + 1], 7);
    },
  };
};

/** dots */
const LENGTH = 36;
/** ticks between two dots */
const EVERY = 4;

/** Dots of light where she has been, brighter where the gun was held. */
export const trail: Skin['trail'] = (stage) => {
  const { player, colours } = stage;
  const coasting = colouredTexture(stage.scene, 'spark', colours.star);
  const held = colouredTexture(stage.scene, 'spark', colours.beam);
  const dots = Array.from({ length: LENGTH }, () => imageOf(stage, 'spark', 7.5).setVisible(false));
  const ticks = new Int32Array(LENGTH).fill(-1);
  let next = 0;
  let last = 0;
  const forget = () => {
    ticks.fill(-1);
    last = player.tick;
    for (const dot of dots) dot.setVisible(false);
  };
  return {
    objects: dots,
    onRestart: forget,
    update() {
      const { tick, state, ending } = player;
      if (tick < last) forget();
      // the dots fade in steps: to change all of them every frame would cost more than it shows
      if (tick - last < EVERY || ending !== null) return;
      last = tick;
      ticks[next] = tick;
      dots[next]
        .setVisible(true)
        .setPosition(state[0], state[1])
        .setTexture(player.held ? held : coasting);
      next = (next + 1) % LENGTH;
      for (let i = 0; i < LENGTH; i++) {
        if (ticks[i] === -1) continue;
        const age = (tick - ticks[i]) / (LENGTH * EVERY);
        const left = Math.max(0, 1 - age);
        dots[i].setAlpha(0.55 * left * left).setScale(0.025 + 0.05 * left);
      }
    },
  };
};
