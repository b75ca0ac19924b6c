import { type AccuracyName, isAccuracyName } from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import type { Certificate, Proof } from '../prove/index.ts';
import { whyNotKnown } from './assumptions.ts';
import { checkNothingInRange, checkOutOfRange, checkStartsInHazard } from './by-distance.ts';
import { type Claim, claimOf, type Play } from './claim.ts';
import { checkCovered } from './covered.ts';
import { checkDoomed } from './doomed.ts';
import { checkEnclosed } from './enclosed.ts';
import { checkFlowpipe } from './flowpipe.ts';
import { isIndex } from './geometry.ts';
import { checkLineTrap } from './line-trap.ts';
import { checkOrbits } from './orbits/index.ts';

/** The result of checking a proof. */
export type Verification =
  | {
      /** The proof holds. */
      readonly ok: true;
    }
  | {
      /** The proof does not hold. */
      readonly ok: false;
      /** The first thing that is wrong, as a clause in English. */
      readonly why: string;
    };

const PLAYS: Readonly<Record<AccuracyName, Play>> = { arcade: 'frames', fast: 'steps', standard: 'steps', precise: 'exact' };

const wrong = (why: string): Verification => ({ ok: false, why });

/**
 * Checks a proof. It uses only the level and the certificate, does not search, and shares no code with the provers. It checks
 * every accuracy that the proof claims to cover. The proof may come from a file: nothing is assumed about it except that it is
 * JSON.
 *
 * What each check rests on is written at the head of its file in `solver/verify`, and in `docs/proofs.md`.
 * @param level the level that the proof is about
 * @param proof the proof, possibly damaged or forged
 * @returns whether the proof holds, and if not, why
 * @example
 * ```ts
 * import { verifyProof } from 'gravity-quest-toolkit/solver';
 *
 * const result = verifyProof(level, JSON.parse(text));
 * if (!result.ok) console.error(`the proof is refused: ${result.why}`);
 * ```
 */
export function verifyProof(level: Level, proof: Proof): Verification {
  const { about, covers, maxTime, certificate, code } = proof;
  if (about?.kind !== 'blackHole' && !(about?.kind === 'mineral' && isIndex(about.index, level.minerals))) {
    return wrong('it is about an object that the level does not have');
  }
  if (
    !Array.isArray(covers) ||
    covers.length === 0 ||
    !covers.every((name) => typeof name === 'string' && isAccuracyName(name))
  ) {
    return wrong('it does not say which accuracies it covers');
  }
  if (maxTime !== null && !(typeof maxTime === 'number' && maxTime > 0)) return wrong('its longest run is not a length of time');
  if (maxTime === null && level.recoil && needsTime(certificate)) return wrong('with recoil it must say how long a run may last');
  if (certificate?.kind !== code) return wrong('its certificate is of another kind');
  const unknown = whyNotKnown(code, level);
  if (unknown !== null) return wrong(unknown);
  for (const play of new Set(covers.map((name) => PLAYS[name]))) {
    const why = check(claimOf(level, about, maxTime, play), certificate);
    if (why !== null) return wrong(why);
  }
  return { ok: true };
}

// What is visible at time 0 does not depend on the length of a run.
const needsTime = (certificate: Certificate): boolean =>
  certificate?.kind !== 'nothing-in-range' && certificate?.kind !== 'starts-in-hazard';

function check(claim: Claim, certificate: Certificate): string | null {
  switch (certificate.kind) {
    case 'nothing-in-range':
      return checkNothingInRange(claim);
    case 'starts-in-hazard':
      return checkStartsInHazard(claim, certificate.hazard);
    case 'out-of-range':
      return checkOutOfRange(claim, certificate.asteroids, certificate.mouths);
    case 'enclosed':
      return checkEnclosed(claim, certificate.barrier);
    case 'line-trap':
      return checkLineTrap(claim, certificate);
    case 'doomed':
      return checkDoomed(claim, certificate);
    case 'flowpipe':
      return checkFlowpipe(claim, certificate);
    case 'orbits':
      return checkOrbits(claim, certificate);
    case 'covered':
      return checkCovered(claim);
  }
}
