import { type AccuracyName, compile, createSimulation, type Scene, type Simulation, STATE_SIZE } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';

/** Place and direction of her box at a tick, exactly as simulated. */
export interface Pose {
  readonly tick: number;
  readonly x: number;
  readonly y: number;
  readonly cos: number;
  readonly sin: number;
}

/** A script, and her poses while the run went on: at ticks, beginning with the start. */
export interface Play {
  readonly holds: readonly Hold[];
  readonly poses: readonly Pose[];
}

/** The ways in which a play presses. */
export const STYLES = ['random', 'taps', 'pump', 'brake', 'off the line', 'momentum', 'speed', 'near'] as const;
export type PlayStyle = (typeof STYLES)[number];

/** Plays a level for up to `ticks` ticks in one of the ways, and keeps her poses. */
export function playLevel(level: Level, accuracy: AccuracyName, style: PlayStyle, random: () => number, ticks: number): Play {
  const scene = compile(level, accuracy);
  const player = new Player(scene, random);
  while (player.tick < ticks && !player.isOver) player.press(style);
  return player.play;
}

class Player {
  private readonly simulation: Simulation;
  private readonly level: Level;
  private readonly random: () => number;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly holds: Hold[] = [];
  private readonly poses: Pose[] = [];
  /** The asteroid nearest to the start, and the direction to it. */
  private readonly centre: { x: number; y: number };
  private readonly line: { x: number; y: number };
  /** The place that `near` tries to reach. */
  private readonly wish: { x: number; y: number };

  constructor(scene: Scene, random: () => number) {
    this.simulation = createSimulation(scene);
    this.level = scene.level;
    this.random = random;
    const { x, y } = this.level.astronaut;
    const far = (c: { x: number; y: number }) => Math.hypot(c.x - x, c.y - y);
    this.centre = this.level.asteroids.reduce((a, b) => (far(b) < far(a) ? b : a), this.level.asteroids[0] ?? { x, y });
    const d = far(this.centre) || 1;
    this.line = { x: (this.centre.x - x) / d, y: (this.centre.y - y) / d };
    this.wish = { x: x + (random() - 0.5) * 600, y: y + (random() - 0.5) * 600 };
    this.keep();
  }

  get tick(): number {
    return this.simulation.tick;
  }

  get isOver(): boolean {
    return this.simulation.ending !== null;
  }

  get play(): Play {
    return { holds: this.holds, poses: this.poses };
  }

  advance(ticks: number, held: boolean): void {
    if (ticks <= 0 || this.isOver) return;
    const last = this.holds[this.holds.length - 1];
    if (held && last?.[1] === this.tick) this.holds[this.holds.length - 1] = [last[0], this.tick + ticks];
    else if (held) this.holds.push([this.tick, this.tick + ticks]);
    for (let n = 0; n < ticks && !this.isOver; n++) {
      this.simulation.advance(1, held);
      if (!this.isOver) this.keep();
    }
  }

  /** Plays the next few ticks in one of the ways. */
  press(style: PlayStyle): void {
    const { random } = this;
    const upTo = (most: number) => 1 + Math.floor(random() * most);
    this.simulation.readState(this.state);
    const [x, y, vx, vy] = this.state;
    const inwards = (this.centre.x - x) * vx + (this.centre.y - y) * vy > 0;
    switch (style) {
      case 'random':
        this.advance(upTo(random() < 0.3 ? 240 : 40), random() < 0.5);
        break;
      case 'taps':
        this.advance(upTo(12), false);
        this.advance(1, true);
        break;
      case 'pump':
        this.advance(1, random() < 0.02 ? !inwards : inwards || (vx === 0 && vy === 0));
        break;
      case 'brake':
        this.advance(upTo(3), random() < 0.15 ? inwards : !inwards || (vx === 0 && vy === 0));
        break;
      default:
        this.greedy(style, upTo(random() < 0.5 ? 3 : 12));
    }
  }

  /** Holds or not: whichever gives more of what the style wants after some ticks. */
  private greedy(style: PlayStyle, ticks: number): void {
    const { simulation, random } = this;
    if (random() < 0.1) {
      this.advance(ticks, random() < 0.5);
      return;
    }
    const here = simulation.snapshot();
    const values = [true, false].map((held) => {
      simulation.restore(here);
      simulation.advance(ticks, held);
      simulation.advance(ticks, random() < 0.5);
      simulation.readState(this.state);
      return simulation.ending === null ? this.worth(style) : Number.NEGATIVE_INFINITY;
    });
    simulation.restore(here);
    this.advance(ticks, values[0] === values[1] ? random() < 0.5 : values[0] > values[1]);
  }

  private worth(style: PlayStyle): number {
    const [x, y, vx, vy] = this.state;
    const dx = x - this.centre.x;
    const dy = y - this.centre.y;
    if (style === 'off the line') return Math.abs(dy * this.line.x - dx * this.line.y);
    if (style === 'momentum') return Math.abs(dx * vy - dy * vx);
    if (style === 'speed') return vx * vx + vy * vy;
    return -Math.hypot(x - this.wish.x, y - this.wish.y);
  }

  private keep(): void {
    this.simulation.readState(this.state);
    const [x, y, , , cos, sin] = this.state;
    this.poses.push({ tick: this.tick, x, y, cos, sin });
  }
}
