/**
 * The state of a run in continuous time is one typed array, so that a snapshot is one copy. It begins with these slots. Then
 * follow the chasers and asteroids, a flag for each mineral, what effects keep for themselves, and the coefficients of the current piece.
 *
 * Files destructure the slots that they need at their top, `const { START } = SLOTS;`. V8 folds constants of the same file into
 * the code; it reads and checks imported ones at every use.
 */
export const SLOTS = {
  /** Time at which the piece begins, s. */
  START: 0,
  /** Events up to this time after START have been handled, s. */
  FROM: 1,
  /** Time after START of the next event or of the natural end, s; then which of them it is. */
  NEXT: 2,
  EVENT: 3,
  EVENT_A: 4,
  EVENT_B: 5,
  TICK_NOW: 6,
  HELD: 7,
  TARGET: 8,
  FIELD: 9,
  /** An asteroid that keeps her within the range. */
  COVER: 10,
  /** The target whose place is the origin of the frame; -1 for a fixed point. */
  BASE: 11,
  BASE_X: 12,
  BASE_Y: 13,
  /** Kind of the flow. */
  KIND: 14,
  TURN: 15,
  COS: 16,
  SIN: 17,
  /**
   * On a line: its direction, a unit vector whose larger component is positive, and her side of the centre along it, +1 or -1.
   */
  SIDE: 18,
  LINE_X: 19,
  LINE_Y: 20,
  /** +1 or -1 while the speed limit holds that axis, otherwise 0. */
  LIMIT_X: 21,
  LIMIT_Y: 22,
  /** The kind of event that ended the run, or 0. */
  OUTCOME: 23,
  TOUCHED: 24,
  END_TIME: 25,
  MINERALS: 26,
  /** The event that fired at START: its guard is at its root, not past it. */
  LAST_EVENT: 27,
  LAST_A: 28,
  DEGREE: 29,
  /** Natural length of the piece, s. */
  LENGTH_H: 30,
  /** Upper bound of |u''| over the piece, px/s². */
  ACCELERATION: 31,
  /** 1 from the first press on if the level has recoil. */
  MOVES: 32,
  AWAKE_COUNT: 33,
  /** LINEAR: when she last crossed the centre, and the time before that; 0 if something else has happened since. */
  CROSSED: 34,
  CROSSED_BEFORE: 35,
  /**
   * The field along whose rim she slides, which counts as containing her, or -1; and the field that acts just outside, or -1
   * for the gun.
   */
  RIM: 36,
  OUTER: 37,
  /** One of LINES: whether she is on a line through the centre of the frame; then how it lies, see `line.ts`. */
  LINE: 38,
  LINE_STEEP: 39,
  LINE_SLOPE: 40,
  /** A point of the line, px; and the number of lines so far. */
  LINE_AT_X: 41,
  LINE_AT_Y: 42,
  LINE_COUNT: 43,
  /** One of MEETINGS: held in a field, where the target is on her line. */
  MEETS: 44,
  /** When a rim was last crossed, and how many more crossings were in quick succession than were not. */
  RIM_TIME: 45,
  CHATTER: 46,
  /** When the target last changed, and how often it changed in that instant. */
  SWITCH_TIME: 47,
  SWITCHES: 48,
  /** The steady force since the piece began, px/s². */
  STEADY_X: 49,
  STEADY_Y: 50,
  /** One of ONSETS: how the next event begins. */
  ONSET: 51,
} as const;

/** Number of slots before the first chaser. */
export const HEAD = 52;

/** Not on a line; on one that moves with the base; on one that stands still or along which the base moves. */
export const LINES = { NONE: 0, LOOSE: 1, FAST: 2 } as const;

/** The target is not on her line or has not been examined; it is ahead of her along it, or behind; it stays in her centre. */
export const MEETINGS = { NOT: 0, AHEAD: 1, BEHIND: -1, TOGETHER: 2 } as const;

/** What the box turns towards. */
export const TURNS = { TURN_NOT: 0, TURN_TO_BASE: 1, TURN_TO_TARGET: 2 } as const;

/**
 * How an event begins: in the course of the piece; it is a contact that stands already where the search for events begins; or
 * she only touches something there, which is no contact, and moves into it.
 */
export const ONSETS = { COMES: 0, STANDS: 1, TOUCHES: 2 } as const;

/** In place of a kind of event: the natural end of a piece, which comes after all of them. */
export const PIECE_END = 1000;

/** Slots per chaser (place, velocity, alertness) and per asteroid (place, velocity). */
export const RECORDS = { CHASER: 5, ROCK: 4 } as const;

/** The alertness of an alien. */
export const ALERTNESS = { ASLEEP: 0, AWAKE: 1, GONE: 2 } as const;
