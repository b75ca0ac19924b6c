import type { Skin } from '../skin.ts';
import { colouredTexture } from '../skin-texture.ts';
import { imageOf } from './pieces.ts';

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
