import type { AccuracyName } from '../../engine/index.ts';
import { ENGINE_ID } from './engine-id.ts';
import type { Play, PlayClaim } from './play.ts';

/** Why a play is not replayed. */
export interface NotReplayed {
  readonly verdict: 'unknown-engine' | 'stale-level' | 'other-accuracy' | 'too-long';
  /** What was expected and what was found. */
  readonly message: string;
}

/** Which plays are taken: those of one accuracy, or `any`. A custom setting, which is no name, takes none. */
export type AcceptedAccuracy = AccuracyName | 'any';

/**
 * Says whether a play is of an accuracy that is not taken. A player who could choose the accuracy would choose the physics.
 * @param play the play
 * @param accepted the name of the accuracy that is taken, or `any`
 * @returns null for a play that is taken
 */
export function whyOtherAccuracy({ accuracy }: Pick<Play, 'accuracy'>, accepted: string): NotReplayed | null {
  if (accepted === 'any' || accuracy === accepted) return null;
  return { verdict: 'other-accuracy', message: `expected a play at the accuracy ${accepted}, found one at ${accuracy}` };
}

/**
 * Says whether a play was made with another engine.
 * @param play the play
 * @returns null for a play of this engine
 */
export const whyOtherEngine = ({ engine }: Pick<Play, 'engine'>): NotReplayed | null =>
  engine === ENGINE_ID
    ? null
    : { verdict: 'unknown-engine', message: `expected a play of engine ${ENGINE_ID}, found one of ${engine}` };

/** What a play is compared with before it is replayed. */
export interface Acceptance {
  /** The hash of the level. */
  readonly hash: string;
  /** The name of the accuracy that is taken, or `any`. */
  readonly accuracy: string;
  /** Ticks that a play may have. */
  readonly maxTicks: number;
}

/**
 * Says why a play is not worth a replay.
 * @param play the play
 * @param acceptance which plays are taken
 * @returns null for a play that can be replayed
 */
export function whyNotReplayed(play: Play, { hash, accuracy, maxTicks }: Acceptance): NotReplayed | null {
  const { level, claim } = play;
  const engine = whyOtherEngine(play);
  if (engine !== null) return engine;
  if (level !== hash) return { verdict: 'stale-level', message: `expected a play of level ${hash}, found one of ${level}` };
  const other = whyOtherAccuracy(play, accuracy);
  if (other !== null) return other;
  if (claim.tick > maxTicks) {
    return { verdict: 'too-long', message: `expected a play of at most ${maxTicks} ticks, found one of ${claim.tick}` };
  }
  return null;
}

/**
 * What a play claims, or is found to be.
 * @param collected how many different minerals that is, where it is known
 */
export function claimInWords({ tick, minerals, outcome }: PlayClaim, collected: number = minerals): string {
  const counted = collected === minerals ? '' : `, counted as ${minerals}`;
  return `${outcome} at tick ${tick} with ${collected} mineral${collected === 1 ? '' : 's'}${counted}`;
}
