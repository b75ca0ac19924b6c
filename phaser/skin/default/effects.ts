import type { GameObjects } from 'phaser';
import type { RunEvent } from '../../../engine/index.ts';
import { dice, type GameColours, TEXTURE_UNIT } from '../../drawing/index.ts';
import type { Skin, SkinStage } from '../skin.ts';
import { colouredTexture } from '../skin-texture.ts';
import { colouredImage, imageOf } from './pieces.ts';

const SPARKS = 96;
const RINGS = 6;
/** share of its speed that a spark keeps after a second */
const DRAG = 0.06;

/** Sparks that fly apart. All are made at once, the oldest is used again. */
class Sparks {
  readonly images: readonly GameObjects.Image[];
  private readonly motion = new Float32Array(4 * SPARKS);
  private readonly age = new Float32Array(SPARKS).fill(1);
  private readonly life = new Float32Array(SPARKS).fill(1);
  private next = 0;
  private readonly roll = dice(5);

  constructor(private readonly stage: SkinStage) {
    this.images = Array.from({ length: SPARKS }, () => imageOf(stage, 'spark', 10).setVisible(false));
  }

  burst(x: number, y: number, colour: string, count: number, speed: number, life: number): void {
    const { motion, roll, stage } = this;
    const white = stage.texture('spark');
    const coloured = colouredTexture(stage.scene, 'spark', colour);
    for (let k = 0; k < count; k++) {
      const i = this.next;
      this.next = (i + 1) % SPARKS;
      const angle = 2 * Math.PI * roll();
      const fast = speed * (0.25 + 0.75 * roll());
      motion[4 * i] = x;
      motion[4 * i + 1] = y;
      motion[4 * i + 2] = fast * Math.cos(angle);
      motion[4 * i + 3] = fast * Math.sin(angle);
      this.age[i] = 0;
      this.life[i] = life * (0.6 + 0.4 * roll());
      this.images[i].setTexture(k % 4 === 0 ? white : coloured).setVisible(true);
    }
  }

  update(seconds: number): void {
    const { motion, age, life, images } = this;
    const kept = DRAG ** seconds;
    for (let i = 0; i < SPARKS; i++) {
      if (age[i] >= life[i]) continue;
      age[i] += seconds;
      const left = 1 - age[i] / life[i];
      if (left <= 0) {
        images[i].setVisible(false);
        continue;
      }
      motion[4 * i] += seconds * motion[4 * i + 2];
      motion[4 * i + 1] += seconds * motion[4 * i + 3];
      motion[4 * i + 2] *= kept;
      motion[4 * i + 3] *= kept;
      images[i]
        .setPosition(motion[4 * i], motion[4 * i + 1])
        .setScale(0.02 + 0.06 * left)
        .setAlpha(left);
    }
  }

  clear(): void {
    for (let i = 0; i < SPARKS; i++) {
      this.age[i] = this.life[i];
      this.images[i].setVisible(false);
    }
  }
}

/** Rings that grow and fade. */
class Rings {
  readonly images: readonly GameObjects.Image[];
  private readonly age = new Float32Array(RINGS).fill(1);
  private readonly life = new Float32Array(RINGS).fill(1);
  private readonly reach = new Float32Array(RINGS);
  private next = 0;

  constructor(private readonly stage: SkinStage) {
    this.images = Array.from({ length: RINGS }, () => colouredImage(stage, 'ring', '#ffffff', 9.5).setVisible(false));
  }

  spread(x: number, y: number, colour: string, reach: number, life: number): void {
    const i = this.next;
    this.next = (i + 1) % RINGS;
    this.age[i] = 0;
    this.life[i] = life;
    this.reach[i] = reach;
    this.images[i]
      .setTexture(colouredTexture(this.stage.scene, 'ring', colour))
      .setPosition(x, y)
      .setVisible(true)
      .setScale(0);
  }

  update(seconds: number): void {
    const { age, life, reach, images } = this;
    for (let i = 0; i < RINGS; i++) {
      if (age[i] >= life[i]) continue;
      age[i] += seconds;
      const left = Math.max(0, 1 - age[i] / life[i]);
      images[i]
        .setVisible(left > 0)
        .setAlpha(0.9 * left)
        .setScale(((1 - left * left) * reach[i]) / TEXTURE_UNIT);
    }
  }

  clear(): void {
    for (let i = 0; i < RINGS; i++) {
      this.age[i] = this.life[i];
      this.images[i].setVisible(false);
    }
  }
}

/** What is shown of an event: its colour, sparks and a ring. */
interface Shown {
  readonly colour: keyof GameColours;
  readonly sparks?: readonly [count: number, speed: number, life: number];
  readonly ring?: readonly [reach: number, life: number];
}

const SHOWN: { readonly [type in RunEvent['type']]?: Shown } = {
  mineral: { colour: 'mineral', sparks: [16, 130, 0.6], ring: [34, 0.45] },
  explosion: { colour: 'alien', sparks: [34, 240, 0.9], ring: [90, 0.6] },
  wake: { colour: 'alien', ring: [60, 0.5] },
  target: { colour: 'beam', sparks: [5, 70, 0.35] },
  effect: { colour: 'holeRim', sparks: [14, 120, 0.6], ring: [44, 0.5] },
  collided: { colour: 'lava', sparks: [44, 260, 0.9], ring: [80, 0.5] },
  completed: { colour: 'holeRim', sparks: [40, 210, 1.1], ring: [120, 0.9] },
  lost: { colour: 'beam', ring: [60, 0.9] },
};

/** Sparks and rings where something happens. */
export const effects: Skin['effects'] = (stage) => {
  const sparks = new Sparks(stage);
  const rings = new Rings(stage);
  return {
    objects: [...sparks.images, ...rings.images],
    onEvent({ event, x, y }) {
      const shown = SHOWN[event.type];
      if (shown === undefined) return;
      const colour = stage.colours[shown.colour];
      const place = event.type === 'completed' ? stage.level.blackHole : { x, y };
      if (shown.sparks !== undefined) sparks.burst(place.x, place.y, colour, ...shown.sparks);
      if (shown.ring !== undefined) rings.spread(place.x, place.y, colour, ...shown.ring);
      if (event.type === 'completed') rings.spread(place.x, place.y, '#ffffff', 70, 0.6);
    },
    onRestart() {
      sparks.clear();
      rings.clear();
    },
    update() {
      sparks.update(stage.seconds);
      rings.update(stage.seconds);
    },
  };
};
