import { ENGINE_ID } from './engine-id.ts';
import { PLAY_LIMITS } from './format.ts';
import type { Play, PlayClaim } from './play.ts';

/** Why a play is not replayed. */
export interface NotReplayed {
  readonly verdict: 'unknown-engine' | 'stale-level' | 'too-long';
  /** What was expected and what was found. */
  readonly message: string;
}

/**
 * Says why a play is not worth a replay.
 * @param play the play
 * @param hash the hash of the level
 * @param maxTicks ticks that a play may have
 * @returns null for a play that can be replayed
 */
export function whyNotReplayed(
  { engine, level, claim }: Play,
  hash: string,
  maxTicks: number = PLAY_LIMITS.ticks,
): NotReplayed | null {
  if (engine !== ENGINE_ID) {
    return { verdict: 'unknown-engine', message: `expected a play of engine ${ENGINE_ID}, found one of ${engine}` };
  }
  if (level !== hash) return { verdict: 'stale-level', message: `expected a play of level ${hash}, found one of ${level}` };
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
