import type { GameObjects, Scene } from 'phaser';
import {
  COLOURS,
  colourNumber,
  type Drawing,
  type Frame,
  lengthAlong,
  linesOf,
  scaleIn,
  strokesOf,
  type Theme,
} from '../../canvas/index.ts';
import { MOST_COMPARED } from './compared.ts';
import { LOOKS, poseOf, type Race, type Racer } from './racers.ts';

/** px of screen */
const WIDTH = 2;
const FONT = 11;
/** px of screen between a figure and its name */
const BESIDE = 6;
const RING = 3;
/** px of screen, and how opaque */
const GLOW = [
  [11, 0.16],
  [7, 0.3],
  [3.2, 0.95],
] as const;
/** letters of a name that are shown */
const MOST_LETTERS = 18;
/** more strokes than this in one path are drawn as one line */
const MOST_STROKES = 3000;
/** How opaque what belongs to the level as it is now is, and what is of an earlier state of it. */
const OPACITY = { fresh: 0.95, stale: 0.4 } as const;

interface Figure {
  readonly body: GameObjects.Image;
  /** Where images can't be tinted, it has the colour. */
  readonly ring: GameObjects.Arc;
  readonly name: GameObjects.Text;
}

const short = (name: string): string => {
  const letters = [...name];
  return letters.length > MOST_LETTERS ? `${letters.slice(0, MOST_LETTERS - 1).join('')}…` : name;
};

/** The first of the others, from the top, that a name lies on. */
const liesOn = (name: GameObjects.Text, others: readonly GameObjects.Text[]): GameObjects.Text | undefined =>
  others.find(
    (other) =>
      name.x < other.x + other.displayWidth &&
      other.x < name.x + name.displayWidth &&
      // a name that stands just below another one does not lie on it, whatever rounding does
      Math.abs(name.y - other.y) < 0.99 * other.displayHeight,
  );

/** Compared runs: their paths in strokes of their own, and her figure with a name where each is now. */
export class RaceLayer implements Drawing<Race> {
  private readonly paths: GameObjects.Graphics;
  private readonly figures: readonly Figure[];
  /** What the paths were last drawn from. */
  private drawn: { readonly racers: readonly Racer[]; readonly frame: Frame } | null = null;

  constructor(
    scene: Scene,
    private readonly theme: Theme,
  ) {
    const { space } = COLOURS[theme];
    this.paths = scene.add.graphics().setDepth(7.6);
    this.figures = Array.from({ length: MOST_COMPARED }, (_, slot) => ({
      body: scene.add.image(0, 0, 'astronaut').setDepth(8.6).setTint(this.colourOf(slot)).setVisible(false),
      ring: scene.add.circle(0, 0, 1).setDepth(8.6).setVisible(false),
      name: scene.add
        .text(0, 0, '', {
          fontFamily: 'system-ui, sans-serif',
          fontSize: `${FONT}px`,
          fontStyle: 'bold',
          color: LOOKS[slot][theme],
          backgroundColor: space,
          padding: { x: 3, y: 1 },
          resolution: Math.max(1, globalThis.devicePixelRatio ?? 1),
        })
        .setDepth(9.5)
        .setOrigin(0, 0.5)
        .setVisible(false),
    }));
  }

  show({ racers, tick }: Race, frame: Frame): void {
    const { drawn } = this;
    if (drawn?.racers !== racers || drawn.frame.zoom !== frame.zoom || drawn.frame.her !== frame.her) this.dress(racers, frame);
    this.pose(racers, tick, frame);
  }

  /** Draws the paths, and the figures as they look. */
  private dress(racers: readonly Racer[], frame: Frame): void {
    const { zoom, her } = frame;
    this.drawn = { racers, frame };
    this.paths.clear();
    for (const { body, ring, name } of this.figures) for (const part of [body, ring, name]) part.setVisible(false);
    for (const racer of racers) {
      this.path(racer, zoom);
      const { body, ring, name } = this.figures[racer.slot];
      const alpha = racer.isStale ? OPACITY.stale : OPACITY.fresh;
      body
        .setVisible(true)
        .setScale(scaleIn(her))
        .setAlpha(0.8 * alpha);
      ring
        .setVisible(true)
        .setAlpha(alpha)
        .setRadius(her.halfHeight + RING / zoom);
      ring.setStrokeStyle(WIDTH / zoom, this.colourOf(racer.slot));
      name
        .setVisible(true)
        .setText(`${racer.slot + 1} ${short(racer.name)}`)
        .setScale(1 / zoom)
        .setAlpha(alpha);
    }
  }

  /** Moves the figures to a moment. Where they are together, their names stand below each other. */
  private pose(racers: readonly Racer[], tick: number, { zoom, her: { halfHeight } }: Frame): void {
    const placed: GameObjects.Text[] = [];
    for (const racer of racers) {
      const { x, y, cos, sin } = poseOf(racer, tick);
      const { body, ring, name } = this.figures[racer.slot];
      body.setPosition(x, y).setRotation(Math.atan2(sin, cos));
      ring.setPosition(x, y);
      name.setPosition(x + halfHeight + BESIDE / zoom, y - halfHeight);
      for (let other = liesOn(name, placed); other !== undefined; other = liesOn(name, placed))
        name.setY(other.y + other.displayHeight);
      placed.push(name);
    }
  }

  destroy(): void {
    this.paths.destroy();
    for (const { body, ring, name } of this.figures) for (const part of [body, ring, name]) part.destroy();
  }

  /** Where a run and its other accuracy part by a pixel. */
  private glow(x: number, y: number, slot: number, zoom: number): void {
    for (const [radius, alpha] of GLOW) this.paths.fillStyle(this.colourOf(slot), alpha).fillCircle(x, y, radius / zoom);
  }

  private colourOf(slot: number): number {
    return colourNumber(LOOKS[slot][this.theme]);
  }

  private path({ slot, points, completes, isStale, parts }: Racer, zoom: number): void {
    this.paths.lineStyle(WIDTH / zoom, this.colourOf(slot), isStale ? OPACITY.stale : OPACITY.fresh).beginPath();
    const pattern = LOOKS[slot].dashes.map((length) => length / zoom);
    for (const line of linesOf(points)) {
      const isLong = lengthAlong(line) / Math.min(...pattern) > MOST_STROKES;
      for (const stroke of isLong ? [line] : strokesOf(line, pattern)) {
        this.paths.moveTo(stroke[0], stroke[1]);
        for (let i = 2; i < stroke.length; i += 2) this.paths.lineTo(stroke[i], stroke[i + 1]);
      }
    }
    this.paths.strokePath();
    const [x, y] = [points[points.length - 2], points[points.length - 1]];
    const arm = 5 / zoom;
    if (parts !== null) this.glow(points[2 * parts], points[2 * parts + 1], slot, zoom);
    // a ring where it completes the level, a cross where it fails
    if (completes) this.paths.strokeCircle(x, y, arm);
    else this.paths.lineBetween(x - arm, y - arm, x + arm, y + arm).lineBetween(x - arm, y + arm, x + arm, y - arm);
  }
}
