import { DEFAULT_RULES, type RuleName } from '../basics/index.ts';

/** A number of the game that a level, or the configuration of a folder, may set. */
export interface GameRule {
  /** The unit, as text. */
  readonly unit: string;
  /** The original game's value. */
  readonly default: number;
  /** The smallest value allowed. */
  readonly least: number;
  /** The largest value allowed. */
  readonly most: number;
  /** What it does, for designers of levels. */
  readonly about: string;
}

/** The game's rules, in the order in which they are listed. */
export const RULES = {
  pull: {
    unit: 'px/s2',
    default: DEFAULT_RULES.pull,
    least: 1,
    most: 1000,
    about: 'Pull of the gun next to its target; it falls evenly to 0 at the range.',
  },
  recoil: {
    unit: 'px2/s2',
    default: DEFAULT_RULES.recoil,
    least: 0,
    most: 1000,
    about: 'How the target of the gun is pulled towards her, where the level has recoil: this over its diameter.',
  },
  push: { unit: 'px/s2', default: DEFAULT_RULES.push, least: 1, most: 1000, about: 'Push of a repulsor away from its centre.' },
  alienPull: {
    unit: 'px/s2',
    default: DEFAULT_RULES.alienPull,
    least: 0,
    most: 1000,
    about: 'How an alien that sees her accelerates towards her.',
  },
  alienSight: {
    unit: 'px',
    default: DEFAULT_RULES.alienSight,
    least: 0,
    most: 10_000,
    about: 'How far an alien sees, from centre to centre.',
  },
  speedLimit: {
    unit: 'px/s',
    default: DEFAULT_RULES.speedLimit,
    least: 10,
    most: 1000,
    about: 'Most that a velocity may have along each axis.',
  },
  boxWidth: {
    unit: 'px',
    default: DEFAULT_RULES.boxWidth,
    least: 1,
    most: 200,
    about: 'Width of her box, along the axis that points at the target.',
  },
  boxHeight: { unit: 'px', default: DEFAULT_RULES.boxHeight, least: 1, most: 200, about: 'Height of her box.' },
} as const satisfies Readonly<Record<RuleName, GameRule>>;
