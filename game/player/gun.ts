import { joinHolds } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';

/** More edges than this do not wait: a press and its release that came too late are dropped together. */
const MOST_WAITING = 3;

/**
 * The gun's button: what was pressed and released between ticks, stamped at ticks. Each tick takes one edge, so that a press
 * shorter than a tick counts as one tick.
 */
export class Gun {
  /** The ticks at which the button changed; the first is a press. */
  private edges: number[] = [];
  private waiting = 0;

  /** Whether the gun is held in the tick that was last simulated. */
  held = false;

  /** Whether the button is down once all edges have been taken. */
  private get down(): boolean {
    return (this.edges.length + this.waiting) % 2 === 1;
  }

  press(): void {
    if (!this.down) this.add();
  }

  release(): void {
    if (this.down) this.add();
  }

  private add(): void {
    this.waiting = this.waiting === MOST_WAITING ? MOST_WAITING - 1 : this.waiting + 1;
  }

  /** Takes the next edge, if one waits, for the tick that begins. @returns whether the gun is held in it */
  take(tick: number): boolean {
    if (this.waiting > 0) {
      this.waiting--;
      this.change(tick);
    }
    return this.held;
  }

  /** Sets the button for the tick that begins, as a replay does. @returns whether the gun is held in it */
  set(tick: number, held: boolean): boolean {
    if (held !== this.held) this.change(tick);
    return held;
  }

  private change(tick: number): void {
    this.edges.push(tick);
    this.held = !this.held;
  }

  /** The holds so far; an open one ends at `tick`. */
  holds(tick: number): Hold[] {
    return holdsOf(this.edges, tick);
  }

  reset(): void {
    this.edges.length = 0;
    this.waiting = 0;
    this.held = false;
  }

  copy(): GunCopy {
    return { edges: this.edges.slice(), waiting: this.waiting };
  }

  paste({ edges, waiting }: GunCopy): void {
    this.edges = edges.slice();
    this.waiting = waiting;
    this.held = edges.length % 2 === 1;
  }
}

/**
 * The holds between edges.
 * @param edges - the ticks at which the button changed; the first is a press
 * @param end - where a hold without a release ends
 */
export function holdsOf(edges: readonly number[], end: number): Hold[] {
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) holds.push([edges[i], edges[i + 1] ?? end]);
  return holds;
}

export interface GunCopy {
  readonly edges: readonly number[];
  readonly waiting: number;
}

/** Holds that are read tick by tick. */
export class Script {
  private readonly holds: readonly Hold[];
  private next = 0;

  constructor(holds: readonly Hold[]) {
    this.holds = joinHolds(holds);
  }

  /** Whether the gun is held in a tick. Reading in order takes constant time. */
  isHeldAt(tick: number): boolean {
    const { holds } = this;
    if (this.next > 0 && tick < holds[this.next - 1][1]) this.next = 0;
    while (this.next < holds.length && holds[this.next][1] <= tick) this.next++;
    return this.next < holds.length && holds[this.next][0] <= tick;
  }
}
