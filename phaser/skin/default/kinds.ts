import { DRAWINGS } from '../../drawing/index.ts';
import type { KindSkin } from '../skin.ts';
import { imageOf, imagesOf } from './pieces.ts';

/** An asteroid, where the recoil has moved it. A hot one glows. */
export const asteroid: KindSkin['asteroid'] = (stage, rock, index) => {
  const objects = imagesOf(stage, DRAWINGS.asteroid.parts(rock, rock.id ?? String(index)), rock, rock.radius);
  const [, glow] = objects;
  return {
    objects,
    update() {
      const { asteroids, time } = stage;
      if (stage.level.recoil) {
        for (let i = 0; i < objects.length; i++) objects[i].setPosition(asteroids[2 * index], asteroids[2 * index + 1]);
      }
      glow?.setAlpha(0.8 + 0.2 * Math.sin(2.2 * time + index));
    },
  };
};

/** An alien: asleep until it wakes, then it looks at her; gone once it has exploded. */
export const alien: KindSkin['alien'] = (stage, one, index) => {
  const { player } = stage;
  const [body, pupil] = imagesOf(stage, DRAWINGS.alien.parts(one), one, one.radius);
  const lid = imageOf(stage, 'lid', 7);
  const { scale } = body;
  let isAwake = false;
  let seen = 0;
  /** Reads the events since the last frame. The list is shorter after a restart, or when the game goes back to a moment. */
  const look = () => {
    const { events } = player;
    if (events.length < seen) {
      seen = 0;
      isAwake = false;
    }
    for (; seen < events.length; seen++) {
      const event = events[seen];
      if ((event.type === 'wake' || event.type === 'sleep') && event.index === index) isAwake = event.type === 'wake';
    }
  };
  return {
    objects: [body, pupil, lid],
    onRestart() {
      seen = 0;
      isAwake = false;
    },
    update() {
      const { aliens, pose, time } = stage;
      look();
      const x = aliens[3 * index];
      const y = aliens[3 * index + 1];
      const isAlive = aliens[3 * index + 2] === 1;
      const breath = isAwake ? 0.015 * Math.sin(14 * time + index) : 0.035 * Math.sin(1.7 * time + index);
      body
        .setVisible(isAlive)
        .setPosition(x, y)
        .setScale(scale * (1 + breath));
      lid
        .setVisible(isAlive && !isAwake)
        .setPosition(x, y)
        .setScale(scale * (1 + breath));
      const dx = pose[0] - x;
      const dy = pose[1] - y;
      const reach = (0.16 * one.radius) / Math.max(1, Math.sqrt(dx * dx + dy * dy));
      pupil.setVisible(isAlive && isAwake).setPosition(x + dx * reach, y + dy * reach - 0.05 * one.radius);
    },
  };
};

/** How long a collected mineral takes to vanish, s. */
const VANISHING = 0.3;

/** A mineral that floats a little, and vanishes when she collects it. */
export const mineral: KindSkin['mineral'] = (stage, one, index) => {
  const { player } = stage;
  const [crystal] = imagesOf(stage, DRAWINGS.mineral.parts(one), one, one.radius);
  const { scale } = crystal;
  let collected = 0;
  return {
    objects: [crystal],
    update() {
      collected = player.isCollected(index) ? collected + stage.seconds : 0;
      const gone = Math.min(1, collected / VANISHING);
      const floating = Math.sin(2.1 * stage.time + 1.7 * index);
      crystal
        .setVisible(gone < 1)
        .setAlpha(1 - gone)
        .setScale(scale * (1 + 0.06 * floating + gone))
        .setPosition(one.x, one.y + 0.1875 * floating * one.radius);
    },
  };
};
