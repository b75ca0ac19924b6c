import {
  Bug,
  Circle,
  CircleDashed,
  Flame,
  Gem,
  Infinity as Loop,
  type LucideIcon,
  Orbit,
  PersonStanding,
  Sun,
  Wind,
} from 'lucide-react';
import { DRAWINGS, type Part, TEXTURE_UNIT } from '../../phaser/index.ts';
import { isVariant, KINDS, type ObjectKind } from '../../schema/index.ts';
import type { Pose } from '../core/context/index.ts';
import type { FoundObject } from '../core/document/index.ts';
import type { Point } from './view.ts';

/** The icon of a kind, in tools and lists. */
interface Sign {
  readonly Icon: LucideIcon;
  readonly tone: 'quiet' | 'bad' | 'good' | 'accent' | 'unknown';
}

/** What a kind may do with an image. */
interface FigureImage {
  readonly scale: number;
  setAlpha(alpha: number): unknown;
  setPosition(x: number, y: number): unknown;
  setRotation(radians: number): unknown;
}

/** An object at one of its places, as shown. */
export interface Figure {
  readonly found: FoundObject;
  /** its place in the level, px */
  readonly at: Point;
  /** px */
  readonly radius: number;
  readonly parts: readonly Part[];
  /** The image of each part. */
  readonly images: readonly FigureImage[];
  /**
   * The offset of each image from the place that its part gives it, px; managed by the kind, kept as long as the object exists.
   */
  readonly away: readonly { x: number; y: number }[];
}

/** How a kind of object is drawn on the canvas. */
interface KindOnCanvas {
  readonly sign: Sign;
  /** The icon of the variant. */
  readonly variantSign?: Sign;
  /** The parts of an object, from below to above. */
  parts(found: FoundObject): readonly Part[];
  /**
   * Shows the object during a run. Without this function it stays in place.
   * @param pose null: as in the level
   * @param zoom px of screen per px of the level
   */
  pose?(figure: Figure, pose: Pose | null, zoom: number): void;
  /** Animates what turns by itself. @param time s */
  turn?(figure: Figure, time: number, zoom: number): void;
}

/** Only her icon: a layer of her own shows her, with the beam of the gun. */
const astronaut: KindOnCanvas = {
  sign: { Icon: PersonStanding, tone: 'quiet' },
  parts: DRAWINGS.astronaut.parts,
};

/** The black hole with its arms, which reach to twice its radius; it turns. */
const blackHole: KindOnCanvas = {
  sign: { Icon: Orbit, tone: 'unknown' },
  parts: DRAWINGS.blackHole.parts,
  turn: ({ images: [body] }, time) => void body.setRotation(DRAWINGS.blackHole.spin * time),
};

/** An asteroid in one of several shapes, with a glow if it is hot. During a run it is shown where the recoil has moved it. */
const asteroid: KindOnCanvas = {
  sign: { Icon: Circle, tone: 'quiet' },
  variantSign: { Icon: Flame, tone: 'bad' },
  parts: ({ kind, key, object }) => DRAWINGS.asteroid.parts({ hot: isVariant(kind, object) }, key),
  pose(figure, pose) {
    const { index } = figure.found;
    const moved = pose !== null && pose.asteroids !== null && pose.asteroids.length > 2 * index;
    if (moved) put(figure, pose.asteroids[2 * index], pose.asteroids[2 * index + 1]);
    else put(figure, figure.at.x, figure.at.y);
  },
};

/** px of screen below which a nova does not turn: it would not be visible, and images at rest cost next to nothing */
const TURNS_FROM = 10;

/** A dwarf nova with a glow; it turns. */
const nova: KindOnCanvas = {
  sign: { Icon: Sun, tone: 'bad' },
  parts: DRAWINGS.nova.parts,
  turn({ found, images: [body] }, time, zoom) {
    if (TEXTURE_UNIT * body.scale * zoom >= TURNS_FROM) body.setRotation(DRAWINGS.nova.spin * time + found.index);
  },
};

const repulsor: KindOnCanvas = {
  sign: { Icon: CircleDashed, tone: 'unknown' },
  parts: DRAWINGS.repulsor.parts,
};

/** px of screen by which a pupil moves at least */
const GAZE = 0.25;

/** An alien that looks at her. During a run it is shown where it has chased her, and faint after its explosion. */
const alien: KindOnCanvas = {
  sign: { Icon: Bug, tone: 'good' },
  parts: DRAWINGS.alien.parts,
  pose(figure, pose, zoom) {
    const { index } = figure.found;
    const moved = pose !== null && pose.aliens !== null && pose.aliens.length > 3 * index;
    const x = moved ? pose.aliens[3 * index] : figure.at.x;
    const y = moved ? pose.aliens[3 * index + 1] : figure.at.y;
    for (const image of figure.images) image.setAlpha(moved && pose.aliens[3 * index + 2] === 0 ? 0.2 : 1);
    const dx = (pose?.x ?? x) - x;
    const dy = (pose?.y ?? y) - y;
    const distance = Math.hypot(dx, dy);
    const reach = distance > 0 ? (0.16 * figure.radius) / distance : 0;
    const gaze = figure.away[1];
    // A smaller change would not be visible, and images that only move cost next to nothing.
    if (zoom * Math.hypot(dx * reach - gaze.x, dy * reach - gaze.y) > GAZE) {
      gaze.x = dx * reach;
      gaze.y = dy * reach;
    }
    put(figure, x, y);
  },
};

/** A mineral with its light; faint once it is collected. */
const mineral: KindOnCanvas = {
  sign: { Icon: Gem, tone: 'accent' },
  parts: DRAWINGS.mineral.parts,
  pose: ({ found, images: [body] }, pose) => void body.setAlpha(pose?.collected.has(found.index) === true ? 0.18 : 1),
};

const usual = (name: string): number => {
  const field = KINDS.wind.fields[name];
  return field.type === 'number' ? (field.default ?? 0) : 0;
};

/** A disc with streaks in the direction of the wind, larger for stronger winds; a small ring for a wind of strength 0. */
const wind: KindOnCanvas = {
  sign: { Icon: Wind, tone: 'accent' },
  parts({ object }) {
    const { ax = usual('ax'), ay = usual('ay') } = object as { ax?: number; ay?: number };
    return DRAWINGS.wind.parts({ ax, ay });
  },
};

/** Both mouths look alike and turn. */
const wormhole: KindOnCanvas = {
  sign: { Icon: Loop, tone: 'accent' },
  parts: DRAWINGS.wormhole.parts,
  turn: ({ images: [body] }, time) => void body.setRotation(DRAWINGS.wormhole.spin * time),
};

/** How each kind of object is drawn on the canvas. */
export const ON_CANVAS: Readonly<Record<ObjectKind, KindOnCanvas>> = {
  astronaut,
  blackHole,
  asteroid,
  nova,
  repulsor,
  alien,
  mineral,
  wind,
  wormhole,
};

/** Moves a figure to a place. */
export function put({ parts, images, away, radius }: Figure, x: number, y: number): void {
  // called thousands of times per frame
  for (let i = 0; i < images.length; i++) {
    const { offset } = parts[i];
    images[i].setPosition(x + (offset?.x ?? 0) * radius + away[i].x, y + (offset?.y ?? 0) * radius + away[i].y);
  }
}

/** The icon of a kind or of its variant. */
export const signOf = (kind: ObjectKind, isVariant: boolean): Sign => {
  const { sign, variantSign } = ON_CANVAS[kind];
  return isVariant ? (variantSign ?? sign) : sign;
};
