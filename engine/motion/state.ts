/**
 * What a run in continuous time is made of: one typed array, so that a snapshot is one copy. First these slots, then the
 * chasers and rocks, a flag for each mineral and repulsor, and the coefficients of the present piece.
 *
 * Files take the slots they need apart at their top, `const { START } = SLOTS;`: V8 folds constants of the file itself
 * into the code, imported ones it reads and checks at every use.
 */
export const SLOTS = {
  /** Time the piece begins, s. */
  START: 0,
  /** Events up to this time after START are behind us, s. */
  FROM: 1,
  /** Time after START of the next event or the natural end, s; then which it is. */
  NEXT: 2,
  EVENT: 3,
  EVENT_A: 4,
  EVENT_B: 5,
  TICK_NOW: 6,
  HELD: 7,
  TARGET: 8,
  FIELD: 9,
  /** An asteroid that keeps her in range. */
  COVER: 10,
  /** The target whose place is the origin of the frame, or -1: a fixed point. */
  BASE: 11,
  BASE_X: 12,
  BASE_Y: 13,
  /** Of flow. */
  KIND: 14,
  TURN: 15,
  COS: 16,
  SIN: 17,
  /** On a line: its direction, a unit vector whose larger component is positive, and +1 or -1: her side of the centre along it. */
  SIDE: 18,
  LINE_X: 19,
  LINE_Y: 20,
  /** +1 or -1 while the speed limit holds that axis. */
  LIMIT_X: 21,
  LIMIT_Y: 22,
  /** The kind of event that ended the run, or 0. */
  OUTCOME: 23,
  TOUCHED: 24,
  END_TIME: 25,
  MINERALS: 26,
  /** The guard that fired at START: it is at its zero, not past it. */
  LAST_EVENT: 27,
  LAST_A: 28,
  DEGREE: 29,
  /** Natural length of the piece, s. */
  LENGTH_H: 30,
  /** Bound on |u''| over the piece, px/s2. */
  ACCELERATION: 31,
  /** 1 from the first press on where the level has recoil. */
  MOVES: 32,
  AWAKE_COUNT: 33,
  /** LINEAR: when she last crossed the centre, and the time before; 0 when something else happened since. */
  CROSSED: 34,
  CROSSED_BEFORE: 35,
  /** The field along whose rim she slides, which counts as around her, or -1; and the one that acts just outside, or -1: the gun. */
  RIM: 36,
  OUTER: 37,
  /** Of LINES: whether she is on a line through the centre of the frame; then how it lies, see line.ts. */
  LINE: 38,
  LINE_STEEP: 39,
  LINE_SLOPE: 40,
  /** A point of it, px; and how many lines there have been. */
  LINE_AT_X: 41,
  LINE_AT_Y: 42,
  LINE_COUNT: 43,
  /** Of MEETINGS: held in a field, where the target is on the line that she is on. */
  MEETS: 44,
  /** When a rim was crossed last, and how many more crossings came in quick succession than not. */
  RIM_TIME: 45,
  CHATTER: 46,
  /** When the target changed last, and how often it did in that instant. */
  SWITCH_TIME: 47,
  SWITCHES: 48,
  /** The steady force that acts since the piece began, px/s2. */
  STEADY_X: 49,
  STEADY_Y: 50,
} as const;

/** Slots before the first chaser. */
export const HEAD = 51;

/** Not on a line; on one that goes where the base goes; on one that stands still or that the base moves along. */
export const LINES = { NONE: 0, LOOSE: 1, FAST: 2 } as const;

/** The target is not on her line, or not looked at; it is ahead of her along it, or behind; it stays in her centre. */
export const MEETINGS = { NOT: 0, AHEAD: 1, BEHIND: -1, TOGETHER: 2 } as const;

/** What turns the box. */
export const TURNS = { TURN_NOT: 0, TURN_TO_BASE: 1, TURN_TO_TARGET: 2 } as const;

/** Stands for the natural end of a piece where the kind of an event does: later than all of them. */
export const PIECE_END = 1000;

/** Slots per chaser (place, velocity, what it is up to) and per rock (place, velocity). */
export const RECORDS = { CHASER: 5, ROCK: 4 } as const;

/** What an alien is up to. */
export const ALERTNESS = { ASLEEP: 0, AWAKE: 1, GONE: 2 } as const;
