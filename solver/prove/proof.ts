import type { AccuracyName } from '../../engine/index.ts';

/** What a proof says can never be touched: the black hole, or one of the minerals. */
export type About =
  | {
      /** The proof is about the black hole. */
      readonly kind: 'blackHole';
    }
  | {
      /** The proof is about a mineral. */
      readonly kind: 'mineral';
      /** Index in the level's list of minerals, from 0. */
      readonly index: number;
    };

/** A reference to an object of the level. */
export interface ThingRef {
  /** The kind of the object. */
  readonly kind: 'nova' | 'asteroid' | 'alien' | 'blackHole';
  /** Index in the level's list of that kind, from 0; 0 for the black hole. */
  readonly index: number;
}

/** What blocks an edge of a barrier: an object that stands still, or that the edge is out of every asteroid's range. */
export type Blocker =
  | ThingRef
  | {
      /** The edge is out of range. */
      readonly kind: 'range';
    };

/** A corner of a barrier, with the straight edge from it to the next corner. The last edge leads back to the first corner. */
export interface BarrierEdge {
  /** x of the corner, px. */
  readonly x: number;
  /** y of the corner, px. */
  readonly y: number;
  /** What blocks the edge. */
  readonly by: Blocker;
}

/** A unit vector. */
export type Direction = readonly [x: number, y: number];

/** How the motion beyond a border is followed, behind which another asteroid is nearer. */
export interface DeadEnd {
  /** The direction in which she moves forward whatever she does. */
  readonly axis: Direction;
  /** Distance between two lines across the axis, px. */
  readonly step: number;
}

/** One end of the stretch on which a line trap holds her. */
export interface LineEnd {
  /** Distance from the start, px; positive towards the asteroid. */
  readonly at: number;
  /**
   * What stops her there: an object that her box must overlap; the end of the range; the start, behind which she cannot go back;
   * or a dead end, where another asteroid becomes the nearest and all paths from there end at hazards.
   */
  readonly by:
    | Blocker
    | {
        /** She cannot go back behind the start. */
        readonly kind: 'start';
      }
    | ({
        /** Another asteroid becomes the nearest here, and all paths beyond end at hazards. */
        readonly kind: 'dead-end';
      } & DeadEnd);
}

/** How far recoil can carry an asteroid along a line. */
export interface Drift {
  /** The farthest towards the start and beyond it, px. */
  readonly back: number;
  /** The farthest away from the start, px. */
  readonly ahead: number;
}

/** The grid of a `doomed` certificate. */
export interface FanGrid {
  /** Direction of the first axis, a unit vector. The second axis is a quarter turn from it, in the sense from x to y. */
  readonly axis: readonly [number, number];
  /** Side of the squares that divide places, px. */
  readonly cell: number;
  /** Side of the squares that divide velocities, px/s. */
  readonly bin: number;
  /** Length of a step, ticks of 1/60 s. */
  readonly frames: number;
}

/**
 * A box of places and velocities: least and greatest along each axis of a grid, in the order x, x, y, y, vx, vx, vy, vy. Places
 * are px from the start, velocities px/s.
 */
export type BoxNumbers = readonly number[];

/** The certificate of a `doomed` proof: sets that contain every state she can reach, until every run has ended. */
export interface Doomed {
  /** The kind of the certificate. */
  readonly kind: 'doomed';
  /** The grid of its boxes. */
  readonly grid: FanGrid;
  /**
   * Boxes that contain the states of all runs that are still going on: at the start, and at the end of each step but the last.
   * No run goes on after the last step.
   */
  readonly layers: readonly (readonly BoxNumbers[])[];
}

/** The grid of a `flowpipe` certificate. */
export interface PipeGrid {
  /** Direction of the first axis, a unit vector. The second axis is a quarter turn from it, in the sense from x to y. */
  readonly axis: Direction;
  /** Side of the squares into which drift places are divided, px. */
  readonly cell: number;
  /** Length of a step, ticks of 1/60 s. */
  readonly frames: number;
  /** Every run has ended after this many steps. */
  readonly steps: number;
  /** Sets are separated by the angle of her box, into this many parts of half a turn. */
  readonly turns: number;
}

/** A strip that is removed from a set, because a hazard overlaps her box everywhere in it. */
export interface Strip {
  /** The hazard. */
  readonly by: ThingRef;
  /** The direction of the strip in eighths of a turn from the first axis, 0 to 7. */
  readonly side: number;
  /** The strip begins this far along its direction, px. */
  readonly at: number;
}

/** What happens to one part of a set. */
export interface PipePart {
  /** The strips that hazards remove. */
  readonly off: readonly Strip[];
  /** Index of the set of the next step that contains the rest; null when nothing is left or all of it is out of range. */
  readonly to: number | null;
}

/** What happens to a set in one step. */
export interface PipeStep {
  /**
   * Where the set is cut, px: four lists of cuts, by x and y of the drift place at the earlier of the grid's two moments, then
   * by x and y at the later one.
   */
  readonly cuts: readonly (readonly number[])[];
  /** What happens to each part, in the order of the cuts; parts along the last list of cuts are adjacent. */
  readonly parts: readonly PipePart[];
}

/**
 * The certificate of a `flowpipe` proof: hints from which the checker computes sets that contain every state she can reach,
 * until every run has ended.
 */
export interface Flowpipe {
  /** The kind of the certificate. */
  readonly kind: 'flowpipe';
  /** The grid of its sets. */
  readonly grid: PipeGrid;
  /**
   * For each step and each set of that step: what happens to it when she presses, and when she does not. The first step has one
   * set, the start.
   */
  readonly layers: readonly (readonly (readonly [pressed: PipeStep, free: PipeStep])[])[];
}

/** The grid of an `orbits` certificate. */
export interface OrbitGrid {
  /**
   * Cells of the distance from an asteroid, px. Directions are divided into cells that are about as wide at a distance of
   * 100 px: a turn has `round(2 pi 100 / place)` of them.
   */
  readonly place: number;
  /** Cells of the radial speed, px/s. */
  readonly speed: number;
  /** Cells of the angular momentum about an asteroid, px²/s. */
  readonly momentum: number;
  /** Length of a step, ticks of 1/60 s. */
  readonly frames: number;
}

/**
 * The certificate of an `orbits` proof: where to divide distance, direction, radial speed and angular momentum about the nearest
 * asteroid. The checker computes by itself the sets that contain every state she can reach.
 */
export interface Orbits {
  /** The kind of the certificate. */
  readonly kind: 'orbits';
  /** The grid of the sets. */
  readonly grid: OrbitGrid;
  /** Every run has ended after this many steps. */
  readonly steps: number;
}

/** The kinds of proof. See {@link Certificate} for what each of them rests on. */
export type ProofCode =
  | 'nothing-in-range'
  | 'starts-in-hazard'
  | 'out-of-range'
  | 'enclosed'
  | 'line-trap'
  | 'doomed'
  | 'covered'
  | 'flowpipe'
  | 'orbits';

/** The engine's warning, by its code, that says less than a proof of each kind and is dropped when there is such a proof. */
export const OUTDONE_WARNINGS: Readonly<Partial<Record<ProofCode, string>>> = {
  'out-of-range': 'black-hole-out-of-reach',
  covered: 'black-hole-covered',
  'nothing-in-range': 'nothing-in-range-at-start',
  'starts-in-hazard': 'starts-in-hazard',
};

/** The provers by name. `dead-end` makes proofs of the kind `line-trap`. */
export type Prover = ProofCode | 'dead-end';

/**
 * The data that the checker needs to confirm a proof: plain JSON, lengths in px. {@link verifyProof} trusts none of it.
 */
export type Certificate =
  | {
      /** She is lost at time 0. The level alone shows it. */
      readonly kind: 'nothing-in-range';
    }
  | {
      /** Her box overlaps a hazard at time 0. */
      readonly kind: 'starts-in-hazard';
      /** The hazard. */
      readonly hazard: ThingRef;
    }
  | {
      /** She cannot come into range of an asteroid from which the object could be touched. */
      readonly kind: 'out-of-range';
      /** Indices of every asteroid that she can ever be in range of. All others lie beyond gaps that she cannot cross. */
      readonly asteroids: readonly number[];
      /**
       * Every mouth that she can ever enter: 2 i for the mouth of wormhole i at (x, y), 2 i + 1 for its other mouth. Absent without
       * wormholes.
       */
      readonly mouths?: readonly number[];
    }
  | {
      /** A barrier separates the start from the object. */
      readonly kind: 'enclosed';
      /** The corners of the closed barrier, in order. */
      readonly barrier: readonly BarrierEdge[];
    }
  | LineTrap
  | Doomed
  | Flowpipe
  | Orbits
  | {
      /** Hazards cover the object. The level alone shows it. */
      readonly kind: 'covered';
    };

/** The certificate of a `line-trap` proof: she cannot leave a stretch of the line through her start and an asteroid. */
export interface LineTrap {
  /** The kind of the certificate. */
  readonly kind: 'line-trap';
  /** Index of the asteroid whose pull keeps her on the line. */
  readonly target: number;
  /** The end of the stretch on the side of the start. */
  readonly back: LineEnd;
  /** The end of the stretch on the side of the asteroid. */
  readonly front: LineEnd;
  /** How far the asteroid drifts while she swings; null without recoil, and when she only falls towards it once. */
  readonly drift: Drift | null;
}

/** A proof that the black hole or a mineral can never be touched, whatever the player does. */
export interface Proof {
  /** The kind of the proof. */
  readonly code: ProofCode;
  /** What can never be touched. */
  readonly about: About;
  /** The reason and a remedy, in one sentence for a designer. */
  readonly reason: string;
  /** The accuracies for which the proof holds. It says nothing about others. */
  readonly covers: readonly AccuracyName[];
  /** The proof holds for runs up to this length, s; null for runs of any length. */
  readonly maxTime: number | null;
  /** What {@link verifyProof} needs to confirm the proof. */
  readonly certificate: Certificate;
}
