import type { GameObjects, Scene } from 'phaser';
import { isJump, STATE_SIZE, TICK } from '../../../engine/index.ts';
import type { Ghost } from '../../core/context/index.ts';
import { isWhole } from '../../core/proof/index.ts';
import { type Colours, colourNumber } from '../colours.ts';
import type { Picture } from '../picture.ts';

/** ticks between the dots of a path */
const DOTS = 6;

/** ticks at the end of a failing path that are drawn in the colour of danger */
const DOOM = 45;

/** More selected paths than this are drawn fainter. */
const CROWD = 4;

/** How each kind of ghost is drawn; widths in px of the screen. */
const GHOST_LINES = {
  attempt: { colour: 'ghost', width: 1, alpha: 0.6 },
  candidate: { colour: 'select', width: 1.6, alpha: 0.6 },
  slack: { colour: 'slack', width: 1, alpha: 0.22 },
  selected: { colour: 'select', width: 2, alpha: 0.9 },
  crowd: { colour: 'select', width: 1.2, alpha: 0.5 },
} as const satisfies Readonly<Record<Ghost['look'] | 'crowd', { colour: keyof Colours; width: number; alpha: number }>>;

/** What the path depends on; in a playtest the run and its details would give the solution away. */
interface WayInput extends Pick<Picture, 'proof' | 'ghosts' | 'layers' | 'showsRun'> {
  /** px of screen per px of the level */
  readonly zoom: number;
}

/** The path of the run: dots at equal times, thick where the gun is held, near misses, and its end; ghosts behind it. */
export class WayLayer {
  private readonly graphics: GameObjects.Graphics;

  constructor(
    scene: Scene,
    private readonly colours: Colours,
  ) {
    this.graphics = scene.add.graphics().setDepth(7.5);
  }

  show(input: WayInput): void {
    this.graphics.clear();
    if (input.layers.ghosts || input.layers.slackFan) this.ghosts(input);
    if (!input.showsRun) return;
    this.way(input);
    if (input.layers.nearMisses) this.nearMisses(input);
    this.end(input);
  }

  destroy(): void {
    this.graphics.destroy();
  }

  private ghosts({ ghosts, layers, zoom, showsRun }: WayInput): void {
    const isCrowd = ghosts.filter(({ look }) => look === 'selected').length > CROWD;
    for (const { points, look } of ghosts) {
      if (look === 'slack' ? !layers.slackFan : !layers.ghosts) continue;
      // attempts by the user give nothing away, and what is selected was asked for
      if (!showsRun && look !== 'attempt' && look !== 'selected') continue;
      const { colour, width, alpha } = GHOST_LINES[look === 'selected' && isCrowd ? 'crowd' : look];
      this.graphics.lineStyle(width / zoom, colourNumber(this.colours[colour]), alpha);
      this.graphics.beginPath();
      for (const line of linesOf(points)) {
        this.graphics.moveTo(line[0], line[1]);
        for (let i = 2; i < line.length; i += 2) this.graphics.lineTo(line[i], line[i + 1]);
      }
      this.graphics.strokePath();
      if (look === 'selected' && points.length > 1) this.ring(points[points.length - 2], points[points.length - 1], zoom);
    }
  }

  /** Where a selected attempt ends. */
  private ring(x: number, y: number, zoom: number): void {
    this.graphics.lineStyle(2 / zoom, colourNumber(this.colours.select), 1).strokeCircle(x, y, 6 / zoom);
  }

  private way({ proof, zoom }: WayInput): void {
    const { states, held, count, last } = proof.run.way;
    const { graphics, colours } = this;
    const completes = proof.run.outcome === 'completed';
    const coast = colourNumber(completes ? colours.way : colours.wayLost);
    const pull = colourNumber(completes ? colours.wayHeld : colours.wayLostHeld);
    const danger = colourNumber(colours.danger);
    // the end of a run that was not simulated completely is unknown
    const doom = completes || !isWhole(proof) ? count : Math.max(0, count - 1 - DOOM);
    const place = (k: number) => [states[k * STATE_SIZE], states[k * STATE_SIZE + 1]] as const;
    // one line for each stretch with the gun held or released
    for (let from = 0; from < count - 1; ) {
      let to = from + 1;
      while (to < count - 1 && to !== doom && held[to] === held[from]) to++;
      const gun = held[from] === 1;
      const colour = from >= doom ? danger : gun ? pull : coast;
      graphics.lineStyle((gun ? 3.2 : from >= doom ? 2 : 1.3) / zoom, colour, gun || from >= doom ? 0.95 : 0.7);
      graphics.beginPath();
      graphics.moveTo(...place(from));
      for (let k = from + 1; k <= to; k++) {
        if (isJump(states, (k - 1) * STATE_SIZE, k * STATE_SIZE, TICK)) graphics.moveTo(...place(k));
        else graphics.lineTo(...place(k));
      }
      graphics.strokePath();
      from = to;
    }
    if (count > 0) {
      const isDoomed = doom < count;
      graphics.lineStyle((isDoomed ? 2 : 1.3) / zoom, isDoomed ? danger : coast, isDoomed ? 0.95 : 0.7);
      if (!endsInJump(states, count, last)) graphics.lineBetween(...place(count - 1), last[0], last[1]);
    }
    for (let k = 0; k < count; k += DOTS) graphics.fillStyle(k >= doom ? danger : coast, 0.9).fillCircle(...place(k), 1.7 / zoom);
    // presses and releases
    for (const [press, release] of proof.run.holds) {
      for (const [tick, filled] of [
        [press, true],
        [release, false],
      ] as const) {
        if (tick >= count) continue;
        const radius = 4.5 / zoom;
        if (filled) graphics.fillStyle(pull, 1).fillCircle(...place(tick), radius);
        else graphics.lineStyle(1.5 / zoom, pull, 1).strokeCircle(...place(tick), radius);
      }
    }
  }

  private nearMisses({ proof, zoom }: WayInput): void {
    const { states } = proof.run.way;
    const colour = colourNumber(this.colours.near);
    for (const { tick } of proof.margins.nearMisses) {
      const x = states[tick * STATE_SIZE];
      const y = states[tick * STATE_SIZE + 1];
      this.graphics
        .lineStyle(1.5 / zoom, colour, 0.95)
        .strokeTriangle(x, y - 9 / zoom, x - 8 / zoom, y + 6 / zoom, x + 8 / zoom, y + 6 / zoom);
    }
  }

  /** Her box where a run ends, with a cross if it fails. */
  private end({ proof, zoom }: WayInput): void {
    const { outcome, way } = proof.run;
    if (outcome === 'timeout') return;
    const [x, y, , , cos, sin] = way.last;
    const { halfWidth, halfHeight } = proof.scene.box;
    const good = outcome === 'completed';
    const colour = colourNumber(good ? this.colours.way : this.colours.danger);
    this.graphics.lineStyle(2 / zoom, colour, 1).beginPath();
    for (const [across, along] of [
      [-1, -1],
      [1, -1],
      [1, 1],
      [-1, 1],
    ]) {
      const dx = across * halfWidth;
      const dy = along * halfHeight;
      this.graphics.lineTo(x + dx * cos - dy * sin, y + dx * sin + dy * cos);
    }
    this.graphics.closePath().strokePath();
    if (good) return;
    const arm = 8 / zoom;
    this.graphics.lineStyle(3 / zoom, colour, 1);
    this.graphics.lineBetween(x - arm, y - arm, x + arm, y + arm).lineBetween(x - arm, y + arm, x + arm, y - arm);
  }
}

/** Whether an effect moves her at once between the last tick and the end of the run, which is at most a tick later. */
function endsInJump(states: Float64Array, count: number, last: Float64Array): boolean {
  const from = (count - 1) * STATE_SIZE;
  const both = new Float64Array(2 * STATE_SIZE);
  both.set(states.subarray(from, from + STATE_SIZE));
  both.set(last.subarray(0, STATE_SIZE), STATE_SIZE);
  const [vx, vy] = [(states[from + 2] + last[2]) / 2, (states[from + 3] + last[3]) / 2];
  const along = (last[0] - states[from]) * vx + (last[1] - states[from + 1]) * vy;
  const speed2 = vx * vx + vy * vy;
  return isJump(both, 0, STATE_SIZE, speed2 > 0 ? Math.min(TICK, Math.max(0, along / speed2)) : 0);
}

/** entries of `points` between two drawn points: every third tick is enough */
const STEP = 6;

/** largest difference between neighbouring steps, px: more than any force causes within three ticks */
const MOST_BEND = 6;

/** error of a second difference due to rounding to Float32, relative to the coordinate */
const ROUNDING = 5e-7;

/** A continuous stretch: x, y in px, alternating. */
export type Line = readonly number[];

/**
 * Splits a path of which only positions are known into continuous lines. It is cut where a step differs from both its
 * neighbours, as no step of a flight does: there an effect moved her at once.
 * @param points x, y in px, two entries per tick
 */
export function linesOf(points: Float32Array): Line[] {
  const lines: number[][] = [];
  let line: number[] = [];
  for (let i = 0; i + 1 < points.length; i += STEP) {
    if (i > 0 && isBreak(points, i - STEP)) {
      lines.push(line);
      line = [];
    }
    line.push(points[i], points[i + 1]);
  }
  if (line.length > 0) lines.push(line);
  return lines;
}

function isBreak(points: Float32Array, from: number): boolean {
  const most = MOST_BEND + ROUNDING * (Math.abs(points[from]) + Math.abs(points[from + 1]));
  const [before, behind] = [from - STEP, from + STEP];
  const neighbours = [before, behind].filter((i) => i >= 0 && i + STEP + 1 < points.length);
  if (neighbours.length === 0 || neighbours.some((other) => bend(points, from, other) <= most)) return false;
  // At either end there is only one neighbour: the longer of the two steps is the jump.
  return neighbours.length === 2 || lengthOf(points, from) > lengthOf(points, neighbours[0]) + most;
}

const lengthOf = (points: Float32Array, from: number): number =>
  Math.hypot(points[from + STEP] - points[from], points[from + STEP + 1] - points[from + 1]);

/** The difference of two steps, px. */
function bend(points: Float32Array, one: number, other: number): number {
  const dx = points[one + STEP] - points[one] - (points[other + STEP] - points[other]);
  const dy = points[one + STEP + 1] - points[one + 1] - (points[other + STEP + 1] - points[other + 1]);
  return Math.hypot(dx, dy);
}
