import type { Scene as Compiled } from '../../engine/index.ts';
import { OBJECT_KINDS, objectsIn, placesIn } from '../../schema/basics/index.ts';
import type { View } from '../skin/index.ts';
import type { CameraMode } from './options.ts';

/** px of the level around the outermost objects */
const MARGIN = 48;
/** px of the level around her that stay visible */
const AROUND_HER = 40;
/** px of the level between her and the edge, at least */
const EDGE = 24;
/** px of the level that the shorter side shows when the view follows her */
const FOLLOWED = 420;
/** the view looks ahead of her by the way of this time, s, but no farther than this share of what it shows */
const AHEAD = 0.35;
const MOST_AHEAD = 0.18;
/** share of the way that the view still has to go after a second */
const LAG = 0.02;
const MOST_ZOOM = 3;

/** The view of a level, which follows what happens without a sudden move. It allocates nothing. */
export class LevelView implements View {
  left = 0;
  top = 0;
  width = 1;
  height = 1;
  x = 0;
  y = 0;
  zoom = 1;
  /** the box around all objects, px */
  private minX = 0;
  private minY = 0;
  private maxX = 0;
  private maxY = 0;
  private wantedX = 0;
  private wantedY = 0;
  private wantedZoom = 1;

  constructor(
    { level, box }: Compiled,
    private readonly mode: CameraMode,
  ) {
    this.minX = this.maxX = level.astronaut.x;
    this.minY = this.maxY = level.astronaut.y;
    this.include(level.astronaut.x, level.astronaut.y, Math.max(box.halfWidth, box.halfHeight));
    this.include(level.blackHole.x, level.blackHole.y, 2 * level.blackHole.radius);
    for (const kind of OBJECT_KINDS) {
      for (const object of objectsIn(level, kind)) {
        const { radius = 0 } = object as { readonly radius?: number };
        for (const { x, y } of placesIn(kind, object)) this.include(x, y, radius);
      }
    }
    this.minX -= MARGIN;
    this.minY -= MARGIN;
    this.maxX += MARGIN;
    this.maxY += MARGIN;
  }

  private include(x: number, y: number, radius: number): void {
    this.minX = Math.min(this.minX, x - radius);
    this.minY = Math.min(this.minY, y - radius);
    this.maxX = Math.max(this.maxX, x + radius);
    this.maxY = Math.max(this.maxY, y + radius);
  }

  /** Takes another size. @returns whether it differs from before */
  place(x: number, y: number, width: number, height: number): boolean {
    const wide = Math.max(1, width);
    const high = Math.max(1, height);
    if (x === this.left && y === this.top && wide === this.width && high === this.height) return false;
    this.left = x;
    this.top = y;
    this.width = wide;
    this.height = high;
    return true;
  }

  /** Shows at once what it would otherwise move to. */
  jump(pose: Readonly<Float64Array>): void {
    this.aim(pose);
    this.x = this.wantedX;
    this.y = this.wantedY;
    this.zoom = this.wantedZoom;
  }

  /** Moves on. @param seconds since the last frame */
  follow(pose: Readonly<Float64Array>, seconds: number): void {
    this.aim(pose);
    const share = 1 - LAG ** seconds;
    this.x += share * (this.wantedX - this.x);
    this.y += share * (this.wantedY - this.y);
    this.zoom += share * (this.wantedZoom - this.zoom);
    if (this.mode === 'none') return;
    // however fast she is, she stays visible
    const reachX = Math.max(0, this.width / (2 * this.zoom) - EDGE);
    const reachY = Math.max(0, this.height / (2 * this.zoom) - EDGE);
    this.x = pose[0] + clamp(this.x - pose[0], reachX);
    this.y = pose[1] + clamp(this.y - pose[1], reachY);
  }

  private aim(pose: Readonly<Float64Array>): void {
    const { width, height } = this;
    if (this.mode === 'none') {
      this.wantedX = this.left + width / 2;
      this.wantedY = this.top + height / 2;
      this.wantedZoom = 1;
      return;
    }
    const whole = zoomFor(this.maxX - this.minX, this.maxY - this.minY, width, height);
    if (this.mode === 'follow') {
      this.wantedZoom = Math.max(whole, Math.min(MOST_ZOOM, Math.min(width, height) / FOLLOWED));
      const reachX = (MOST_AHEAD * width) / this.wantedZoom;
      const reachY = (MOST_AHEAD * height) / this.wantedZoom;
      this.wantedX = within(pose[0] + clamp(AHEAD * pose[2], reachX), width / this.wantedZoom, this.minX, this.maxX);
      this.wantedY = within(pose[1] + clamp(AHEAD * pose[3], reachY), height / this.wantedZoom, this.minY, this.maxY);
      return;
    }
    const minX = Math.min(this.minX, pose[0] - AROUND_HER);
    const minY = Math.min(this.minY, pose[1] - AROUND_HER);
    const maxX = Math.max(this.maxX, pose[0] + AROUND_HER);
    const maxY = Math.max(this.maxY, pose[1] + AROUND_HER);
    this.wantedX = (minX + maxX) / 2;
    this.wantedY = (minY + maxY) / 2;
    this.wantedZoom = zoomFor(maxX - minX, maxY - minY, width, height);
  }
}

const zoomFor = (wide: number, high: number, width: number, height: number): number =>
  Math.min(MOST_ZOOM, width / wide, height / high);

const clamp = (value: number, most: number): number => Math.max(-most, Math.min(most, value));

/** The middle of a span of this length: around `at`, but no farther out than needed to show it. */
function within(at: number, length: number, from: number, to: number): number {
  if (length >= to - from) return (from + to) / 2;
  // she may be outside of the level's box
  return Math.max(Math.min(from + length / 2, at + length / 3), Math.min(Math.max(to - length / 2, at - length / 3), at));
}
