import { type Circles, EFFECTS, type Scene, TICK_RATE } from '../../../engine/index.ts';

/** How far recoil or the step of a frame may move objects away from what is computed here, px. */
const SLACK = 0.25;

/**
 * Predicts the drift after a release: a straight line, on which her box keeps its angle. The moving box sweeps a strip, so she
 * touches a circle exactly if its centre is nearer to the line than the strip's half width plus the circle's radius. What chases
 * her is ignored, and a line through a disc in which another force takes the gun's place counts as blocked.
 */
export class LineOfFlight {
  private readonly scene: Scene;
  private readonly hotCount: number;
  private readonly fields: readonly Circles[];
  private readonly box: Scene['box'];
  private x = 0;
  private y = 0;
  private ux = 0;
  private uy = 0;
  private speed = 0;
  private halfWidth = 0;

  constructor(scene: Scene) {
    this.scene = scene;
    this.box = scene.box;
    this.hotCount = scene.targets.count - scene.coldCount;
    this.fields = EFFECTS.flatMap(({ force, frame, calledFor }) =>
      force?.acts === 'instead' && frame !== undefined && calledFor(scene.level).called ? [frame.discs(scene)] : [],
    );
  }

  /** Starts the line at a state as `Simulation.readState` gives it. */
  from(state: Float64Array): void {
    const vx = state[2];
    const vy = state[3];
    const speed = Math.sqrt(vx * vx + vy * vy);
    this.x = state[0];
    this.y = state[1];
    this.speed = speed;
    this.ux = speed > 0 ? vx / speed : 0;
    this.uy = speed > 0 ? vy / speed : 0;
    const { ux, uy, box } = this;
    // How far the box extends to each side of the line.
    const across = Math.abs(ux * state[5] - uy * state[4]);
    this.halfWidth = box.halfWidth * across + box.halfHeight * Math.abs(ux * state[4] + uy * state[5]);
  }

  /** Distance along the line until she touches a circle, px; -1 if she never does. */
  distanceTo(cx: number, cy: number, r: number): number {
    const dx = cx - this.x;
    const dy = cy - this.y;
    const along = dx * this.ux + dy * this.uy;
    if (!(along > 0)) return -1;
    const aside = dx * this.uy - dy * this.ux;
    const reach = this.halfWidth + r;
    const left = reach * reach - aside * aside;
    if (!(left > 0)) return -1;
    const distance = along - Math.sqrt(left);
    return distance > 0 ? distance : 0;
  }

  /** The ticks it takes to fly this many px. */
  ticksFor(distance: number): number {
    return (distance / this.speed) * TICK_RATE;
  }

  /** Whether the next `distance` px are free of hazards and fields, with an asteroid in range all the way. */
  isClear(distance: number): boolean {
    const { novae, targets, coldCount } = this.scene;
    for (let i = 0; i < novae.count; i++) if (this.isBarred(novae.x[i], novae.y[i], novae.r[i], distance)) return false;
    for (let i = coldCount; i < coldCount + this.hotCount; i++) {
      if (this.isBarred(targets.x[i], targets.y[i], targets.r[i], distance)) return false;
    }
    for (const field of this.fields) {
      for (let i = 0; i < field.count; i++) if (this.leadsThrough(field.x[i], field.y[i], field.r[i], distance)) return false;
    }
    return this.staysInRange(distance);
  }

  /** Whether her centre comes into a disc within the next `distance` px. */
  private leadsThrough(cx: number, cy: number, r: number, distance: number): boolean {
    const dx = cx - this.x;
    const dy = cy - this.y;
    const aside = dx * this.uy - dy * this.ux;
    const along = dx * this.ux + dy * this.uy;
    const left = r * r - aside * aside;
    if (left <= 0) return false;
    const half = Math.sqrt(left);
    return along + half > 0 && along - half < distance;
  }

  private isBarred(cx: number, cy: number, r: number, distance: number): boolean {
    const hit = this.distanceTo(cx, cy, r - SLACK);
    return hit >= 0 && hit < distance;
  }

  private staysInRange(distance: number): boolean {
    const { targets, level } = this.scene;
    const reach = level.range * level.range;
    let covered = 0;
    for (;;) {
      let farthest = covered;
      for (let i = 0; i < targets.count; i++) {
        const dx = targets.x[i] - this.x;
        const dy = targets.y[i] - this.y;
        const along = dx * this.ux + dy * this.uy;
        const aside = dx * this.uy - dy * this.ux;
        const left = reach - aside * aside;
        if (left <= 0) continue;
        const half = Math.sqrt(left);
        if (along - half <= covered && along + half > farthest) farthest = along + half;
      }
      if (farthest >= distance) return true;
      if (farthest <= covered) return false;
      covered = farthest;
    }
  }
}
