import { type Hold, type Level, OBJECT_LISTS, type ObjectList } from '../../schema/index.ts';

/** What a peer's own contact detection reported first: an overlap, or the rule's range. */
export type PeerOutcome = 'completed' | 'collided' | 'lost' | null;

/** A level in another engine's world, stepped at a fixed rate. */
export interface PeerWorld {
  /** Makes one step of 1 / rate s with the gun held or not. */
  step(held: boolean): void;
  /** Writes x, y (px), vx, vy (px/s) to `out`. */
  read(out: Float64Array): void;
  /** The first outcome; the world goes on after it, since its cost is measured. */
  readonly outcome: PeerOutcome;
  /** Frees what the engine does not free by itself. */
  dispose(): void;
}

/** Another physics engine, behind the interface that all peers share. */
export interface Peer {
  readonly name: string;
  /** Precision of its floating-point numbers. */
  readonly precision: 'double' | 'single';
  /** Loads the engine (WebAssembly, stubs); to be called once. */
  load(): Promise<void>;
  /**
   * Creates a world.
   * @param rate - steps per second
   * @throws {RangeError} for a level with parts that peers do not support: see {@link unsupportedIn}
   */
  create(level: Level, rate: number): PeerWorld;
}

/** A peer's run: the state at every full second and at the end, and the first outcome that its contacts reported. */
export interface PeerRun {
  /** t (s), x, y (px), vx, vy (px/s) */
  readonly samples: readonly (readonly [t: number, x: number, y: number, vx: number, vy: number])[];
  readonly outcome: PeerOutcome;
  /** Time of the step that reported it, s. */
  readonly outcomeTime: number | null;
}

/** The lists of objects that every peer supports or may ignore. */
const SUPPORTED: ReadonlySet<ObjectList> = new Set<ObjectList>(['asteroids', 'novae', 'minerals']);

/** What peers do not support of a level: lists of objects, recoil, rules of its own. Empty if there is nothing. */
export function unsupportedIn(level: Level): string[] {
  return [
    ...OBJECT_LISTS.filter((list) => !SUPPORTED.has(list) && level[list].length > 0),
    ...(level.recoil ? ['recoil'] : []),
    ...(level.rules === undefined ? [] : ['rules of its own']),
  ];
}

/** @throws {RangeError} for a level with parts that peers do not support */
export function requireSupported(level: Level): void {
  const found = unsupportedIn(level);
  if (found.length > 0)
    throw new RangeError(
      `expected a level of asteroids, novae and minerals for a peer, found ${found.join(', ')} in '${level.name}'`,
    );
}

/** The button at every step: 1 while held. A step of another rate has the button of the tick in which it begins. */
export function buttonPerStep(holds: readonly Hold[], steps: number, rate: number): Uint8Array {
  const button = new Uint8Array(steps);
  for (const [press, release] of holds) {
    const from = Math.ceil((press * rate) / 60);
    const to = Math.ceil((release * rate) / 60);
    button.fill(1, Math.min(from, steps), Math.min(to, steps));
  }
  return button;
}

/** Plays a script in a peer's world from its start; `rate` is in steps per second. */
export function simulatePeer(peer: Peer, level: Level, holds: readonly Hold[], seconds: number, rate: number): PeerRun {
  const world = peer.create(level, rate);
  const steps = Math.round(seconds * rate);
  const button = buttonPerStep(holds, steps, rate);
  const state = new Float64Array(4);
  const samples: [number, number, number, number, number][] = [];
  let outcomeTime: number | null = null;
  for (let i = 0; i < steps; i++) {
    if (i % rate === 0) {
      world.read(state);
      samples.push([i / rate, state[0], state[1], state[2], state[3]]);
    }
    world.step(button[i] === 1);
    if (outcomeTime === null && world.outcome !== null) outcomeTime = (i + 1) / rate;
  }
  world.read(state);
  samples.push([steps / rate, state[0], state[1], state[2], state[3]]);
  const { outcome } = world;
  world.dispose();
  return { samples, outcome, outcomeTime };
}

/** Plays a scene in worlds of a peer as a contestant does: each world is made before it is timed. */
export function peerPlayer(
  peer: Peer,
  { level, holds, seconds }: { readonly level: Level; readonly holds: readonly Hold[]; readonly seconds: number },
  rate: number,
): { prepare(): void; run(): number } {
  const button = buttonPerStep(holds, seconds * rate, rate);
  const state = new Float64Array(4);
  let world = peer.create(level, rate);
  return {
    prepare() {
      world.dispose();
      world = peer.create(level, rate);
    },
    run() {
      for (const held of button) world.step(held === 1);
      world.read(state);
      return state[0] + state[1];
    },
  };
}
