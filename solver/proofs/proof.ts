import type { AccuracyName } from '../../engine/index.ts';

/** What a proof says can never be touched. */
export type About = { readonly kind: 'blackHole' } | { readonly kind: 'mineral'; readonly index: number };

/** A thing of the level, by its place in the level's own list of that kind. */
export interface ThingRef {
  readonly kind: 'nova' | 'asteroid' | 'alien' | 'blackHole';
  readonly index: number;
}

/** What blocks a piece of a barrier: a thing that stands still, or that all of it is out of range. */
export type Blocker = ThingRef | { readonly kind: 'range' };

/** The corner of a barrier, px, and what blocks the straight edge from here to the next corner; after the last comes the first. */
export interface BarrierEdge {
  readonly x: number;
  readonly y: number;
  readonly by: Blocker;
}

/** A unit vector. */
export type Direction = readonly [x: number, y: number];

/** How all that she may do beyond the border to another asteroid's cell is followed. */
export interface DeadEnd {
  /** the direction in which she goes forward whatever she does */
  readonly axis: Direction;
  /** from one line across the axis to the next, px */
  readonly step: number;
}

/**
 * Where along a line her box must overlap something that ends the run, px from the start; or where she can't go back beyond; or where another
 * asteroid becomes the nearer one, and whatever she does from there ends at hazards.
 */
export interface LineEnd {
  readonly at: number;
  readonly by: Blocker | { readonly kind: 'start' } | ({ readonly kind: 'dead-end' } & DeadEnd);
}

/** How far recoil can carry an asteroid along a line, px: towards the start or beyond it, and away from it. */
export interface Drift {
  readonly back: number;
  readonly ahead: number;
}

/** How finely all that she may do is followed, and along which axes. */
export interface FanGrid {
  /** direction of its first axis, a unit vector; the second is a quarter turn from it, from x to y */
  readonly axis: readonly [number, number];
  /** side of the squares that places are cut into, px */
  readonly cell: number;
  /** the same for velocities, px/s */
  readonly bin: number;
  /** length of a step, ticks of 1/60 s */
  readonly frames: number;
}

/** Places and velocities, least and most of each along the axes of a grid: x, x, y, y, vx, vx, vy, vy; px from the start and px/s. */
export type BoxNumbers = readonly number[];

/** Certificate of all that she may do until it is over. */
export interface Doomed {
  readonly kind: 'doomed';
  readonly grid: FanGrid;
  /** for the start, and for the end of each step but the last: boxes that hold every run that goes on; after the last step none does */
  readonly layers: readonly (readonly BoxNumbers[])[];
}

/** How finely all that she may do is followed as sets bounded by where she would drift to. */
export interface PipeGrid {
  /** direction of its first axis, a unit vector; the second is a quarter turn from it, from x to y */
  readonly axis: Direction;
  /** side of the squares that the places she would drift to are cut into, px */
  readonly cell: number;
  /** length of a step, ticks of 1/60 s */
  readonly frames: number;
  /** after so many steps everything is over */
  readonly steps: number;
  /** sets are kept apart by which of so many parts of half a turn her box points into */
  readonly turns: number;
}

/** A strip taken off a set, since a hazard overlaps her box in all of it: beyond `at` px in one of eight directions, eighths of a turn from the first axis. */
export interface Strip {
  readonly by: ThingRef;
  readonly side: number;
  readonly at: number;
}

/** What becomes of a part of a set: strips are taken off, and what is left goes into a set of the next step; null: nothing is left, or all is out of range. */
export interface PipePart {
  readonly off: readonly Strip[];
  readonly to: number | null;
}

/**
 * How a set goes on: where it is cut, px, by the places she drifts to at the two moments of the grid (x and y of the earlier, x and y of the later), and what
 * becomes of each part; those along the last cuts come one after the other.
 */
export interface PipeStep {
  readonly cuts: readonly (readonly number[])[];
  readonly parts: readonly PipePart[];
}

/** Certificate of all that she may do until it is over, known by where she would drift to. */
export interface Flowpipe {
  readonly kind: 'flowpipe';
  readonly grid: PipeGrid;
  /** for each step, and each set there is then, how it goes on when she presses in it, and when she doesn't; the start is one set */
  readonly layers: readonly (readonly (readonly [pressed: PipeStep, free: PipeStep])[])[];
}

/** The kinds of proof. */
export type ProofCode =
  | 'nothing-in-range'
  | 'starts-in-hazard'
  | 'out-of-range'
  | 'enclosed'
  | 'line-trap'
  | 'doomed'
  | 'covered'
  | 'flowpipe';

/** The ways to prove: `dead-end` makes proofs of the kind `line-trap`. */
export type Prover = ProofCode | 'dead-end';

/**
 * What the checker in solver/verify needs to see that a proof holds: plain JSON, lengths in px.
 * - `nothing-in-range`: the level alone shows it
 * - `starts-in-hazard`: the hazard her box overlaps at time 0
 * - `out-of-range`: every asteroid she can ever be in range of, and every mouth of a wormhole she can ever come into; all others lie beyond gaps she can't cross
 * - `enclosed`: a closed line between the start and the thing, each edge of which one hazard blocks, or the range
 * - `line-trap`: the asteroid whose line she is bound to, the ends of the stretch that she can't leave, and with recoil how far the asteroid drifts
 *   while she swings between them
 * - `covered`: the level alone shows it
 * - `doomed`: all that she may do, as sets after each step; after the last none is left
 * - `flowpipe`: how to follow all that she may do: where to cut sets, and what ends which part of them, until none is left
 */
export type Certificate =
  | { readonly kind: 'nothing-in-range' }
  | { readonly kind: 'starts-in-hazard'; readonly hazard: ThingRef }
  | {
      readonly kind: 'out-of-range';
      readonly asteroids: readonly number[];
      /** 2 i for the mouth of wormhole i at (x, y), 2 i + 1 for the other; left out where there is none */
      readonly mouths?: readonly number[];
    }
  | { readonly kind: 'enclosed'; readonly barrier: readonly BarrierEdge[] }
  | LineTrap
  | Doomed
  | Flowpipe
  | { readonly kind: 'covered' };

/** Certificate of a line trap. */
export interface LineTrap {
  readonly kind: 'line-trap';
  readonly target: number;
  readonly back: LineEnd;
  readonly front: LineEnd;
  /** null where there is no recoil, and where she only falls */
  readonly drift: Drift | null;
}

/** A proof that the black hole, or a mineral, can never be touched in a level, whatever the player does. */
export interface Proof {
  readonly code: ProofCode;
  readonly about: About;
  /** why, for a designer, in a sentence, and what to do about it */
  readonly reason: string;
  /** the accuracies it holds for: use it for no other */
  readonly covers: readonly AccuracyName[];
  /** it holds for runs up to this long, s; null: however long */
  readonly maxTime: number | null;
  readonly certificate: Certificate;
}
