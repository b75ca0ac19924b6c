import type { Scene } from 'phaser';
import { DEFAULT_RADIUS, type LevelFile } from '../../../schema/index.ts';
import type { Pose } from '../../context/index.ts';
import { ASTRONAUT, type FoundObject, type ObjectKey, objectsOf, radiusOf } from '../../document/index.ts';
import { ROCKS, TEXTURE_UNIT } from '../textures/index.ts';
import type { Thing } from './thing.ts';
import { ThingLayer } from './thing-layer.ts';

/** Turns of a black hole and of a nova, radians a second. */
const SPIN = { 'black-hole': -0.5, nova: 0.12 } as const;

/** A nova that is smaller than this, px of screen, does not turn: nobody would see it, and what stands still costs next to nothing. */
const TURNS_FROM = 10;

/** px of screen that a pupil moves by at least. */
const GAZE = 0.25;

/** Which is drawn above which. */
const DEPTH = { repulsor: 1, blackHole: 2, glow: 3, asteroid: 4, nova: 5, mineral: 6, alien: 7, astronaut: 9 } as const;

/** The unit circle of a texture covers more than what is touched, for those with a light around them. */
const SIZE = { 'black-hole': 2, mineral: 1.8 } as const;

/** An object on the canvas. */
interface Shown {
  readonly found: FoundObject;
  readonly body: Thing;
  readonly glow: Thing | null;
  readonly pupil: Thing | null;
  /** Where the pupil is from the middle, px. */
  readonly gaze: { x: number; y: number };
}

/** A shape that stays with an asteroid as long as it lives: made from its id. */
function rockOf(key: ObjectKey): number {
  let sum = 0;
  for (let i = 0; i < key.length; i++) sum = (sum * 31 + key.charCodeAt(i)) % 9973;
  return sum % ROCKS;
}

function textureOf(found: FoundObject): string {
  const { kind, key } = found;
  if (kind === 'asteroid') return `${isHot(found) ? 'hot' : 'rock'}-${rockOf(key)}`;
  return kind === 'blackHole' ? 'black-hole' : kind;
}

const isHot = ({ object }: FoundObject): boolean => 'hot' in object && object.hot === true;

/** Whether an object is what it was but for its place. */
const looksSame = (found: FoundObject, old: FoundObject): boolean =>
  found.kind === old.kind && isHot(found) === isHot(old) && found.object.radius === old.object.radius;

/** The things of a level as sprites; only those that changed are touched. */
export class ObjectLayer {
  private readonly shown = new Map<ObjectKey, Shown>();
  private readonly layer: ThingLayer;
  private file: LevelFile | null = null;
  /** Those that turn by themselves. */
  private turning: readonly Shown[] = [];

  constructor(scene: Scene) {
    this.layer = new ThingLayer(scene).setDepth(DEPTH.repulsor);
  }

  /** Forgets all sprites: the textures are new. */
  clear(): void {
    for (const one of this.shown.values()) this.destroy(one);
    this.shown.clear();
    this.layer.forget();
    this.turning = [];
    this.file = null;
  }

  show(file: LevelFile): void {
    if (file === this.file) return;
    this.file = file;
    const objects = objectsOf(file);
    for (const [key, one] of this.shown) {
      if (objects.has(key)) continue;
      this.destroy(one);
      this.shown.delete(key);
    }
    for (const found of objects.values()) {
      if (found.key === ASTRONAUT) continue;
      const old = this.shown.get(found.key);
      if (old !== undefined && old.found.object === found.object && old.found.index === found.index) continue;
      this.shown.set(found.key, this.place(found, old));
    }
    this.turning = [...this.shown.values()].filter(({ found: { kind } }) => kind === 'blackHole' || kind === 'nova');
  }

  /**
   * Aliens and rocks where they are in a run, taken minerals faint; null: everything as the level has it.
   * @param zoom px of screen per px of the level
   */
  pose(pose: Pose | null, zoom: number): void {
    for (const one of this.shown.values()) {
      const { kind, index, object } = one.found;
      if (kind === 'asteroid') {
        const moved = pose !== null && pose.asteroids !== null && pose.asteroids.length > 2 * index;
        this.move(one, moved ? pose.asteroids[2 * index] : object.x, moved ? pose.asteroids[2 * index + 1] : object.y);
      } else if (kind === 'alien') {
        const moved = pose !== null && pose.aliens !== null && pose.aliens.length > 3 * index;
        const x = moved ? pose.aliens[3 * index] : object.x;
        const y = moved ? pose.aliens[3 * index + 1] : object.y;
        const radius = radiusOf(one.found) ?? DEFAULT_RADIUS.alien;
        this.move(one, x, y);
        one.body.setAlpha(moved && pose.aliens[3 * index + 2] === 0 ? 0.2 : 1);
        // it looks at her
        const dx = (pose?.x ?? x) - x;
        const dy = (pose?.y ?? y) - y;
        const away = Math.hypot(dx, dy);
        const reach = away > 0 ? (0.16 * radius) / away : 0;
        const { gaze } = one;
        // less than that nobody would see, and what is dragged as it is costs next to nothing
        if (zoom * Math.hypot(dx * reach - gaze.x, dy * reach - gaze.y) > GAZE) {
          gaze.x = dx * reach;
          gaze.y = dy * reach;
        }
        one.pupil?.setPosition(x + gaze.x, y - 0.05 * radius + gaze.y).setAlpha(one.body.alpha);
      } else if (kind === 'mineral') {
        one.body.setAlpha(pose?.collected.has(index) === true ? 0.18 : 1);
      }
    }
  }

  /**
   * @param time s, for what turns by itself
   * @param zoom px of screen per px of the level
   */
  animate(time: number, zoom: number): void {
    for (const { found, body } of this.turning) {
      if (found.kind === 'blackHole') body.setRotation(SPIN['black-hole'] * time);
      else if (TEXTURE_UNIT * body.scale * zoom >= TURNS_FROM) {
        body.setRotation(SPIN.nova * time + found.index);
      }
    }
  }

  private place(found: FoundObject, old: Shown | undefined): Shown {
    if (old !== undefined && looksSame(found, old.found)) {
      const shown = { ...old, found };
      this.move(shown, found.object.x, found.object.y);
      return shown;
    }
    const texture = textureOf(found);
    const body = old?.body ?? this.layer.addThing(texture, DEPTH[found.kind]);
    if (body.texture.key !== texture) body.setTexture(texture);
    const hot = found.kind === 'nova' || texture.startsWith('hot');
    const glow = hot ? (old?.glow ?? this.layer.addThing('glow', DEPTH.glow)) : null;
    if (!hot) old?.glow?.destroy();
    const pupil = found.kind === 'alien' ? (old?.pupil ?? this.layer.addThing('pupil', DEPTH.alien)) : null;
    const radius = radiusOf(found) ?? 0;
    const scale = radius / TEXTURE_UNIT;
    body.setScale(scale * (texture in SIZE ? SIZE[texture as keyof typeof SIZE] : 1));
    glow?.setScale(1.9 * scale);
    pupil?.setScale(0.2 * scale);
    const shown = { found, body, glow, pupil, gaze: old?.gaze ?? { x: 0, y: 0 } };
    this.move(shown, found.object.x, found.object.y);
    return shown;
  }

  private move({ body, glow, pupil, found, gaze }: Shown, x: number, y: number): void {
    body.setPosition(x, y);
    glow?.setPosition(x, y);
    pupil?.setPosition(x + gaze.x, y - 0.05 * (radiusOf(found) ?? 0) + gaze.y);
  }

  private destroy({ body, glow, pupil }: Shown): void {
    body.destroy();
    glow?.destroy();
    pupil?.destroy();
  }
}
