import { type AccuracyName, isAccuracyName } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import type { Certificate, Proof } from '../proofs/index.ts';
import { whyNotKnown } from './assumptions.ts';
import { checkNothingInRange, checkStartsInHazard } from './at-start.ts';
import { type Claim, claimOf, type Play } from './claim.ts';
import { checkCovered } from './covered.ts';
import { checkDoomed } from './doomed.ts';
import { checkEnclosed } from './enclosed.ts';
import { checkFlowpipe } from './flowpipe.ts';
import { checkLineTrap } from './line-trap.ts';
import { checkOutOfRange } from './out-of-range.ts';
import { isIndex } from './rounded.ts';

/** What the checker says of a proof: that it holds, or the first thing that doesn't. */
export type Verification = { readonly ok: true } | { readonly ok: false; readonly why: string };

const PLAYS: Readonly<Record<AccuracyName, Play>> = { arcade: 'frames', fast: 'steps', standard: 'steps', precise: 'exact' };

const wrong = (why: string): Verification => ({ ok: false, why });

/**
 * Checks a proof from nothing but the level and the certificate, without searching: for every accuracy that it claims to
 * cover. Shares no code with what makes proofs. The proof may come from a file: nothing about it is taken for granted but that it is JSON.
 */
export function verifyProof(level: Level, proof: Proof): Verification {
  const { about, covers, maxTime, certificate, code } = proof;
  if (about?.kind !== 'blackHole' && !(about?.kind === 'mineral' && isIndex(about.index, level.minerals))) {
    return wrong('it is about nothing that the level has');
  }
  if (
    !Array.isArray(covers) ||
    covers.length === 0 ||
    !covers.every((name) => typeof name === 'string' && isAccuracyName(name))
  ) {
    return wrong('it does not say which accuracies it covers');
  }
  if (maxTime !== null && !(typeof maxTime === 'number' && maxTime > 0)) return wrong('its longest run is no length of time');
  if (maxTime === null && level.recoil && needsTime(certificate))
    return wrong('with recoil it needs to say how long a run may last');
  if (certificate?.kind !== code) return wrong('its certificate is of another kind');
  const unknown = whyNotKnown(code, level);
  if (unknown !== null) return wrong(unknown);
  for (const play of new Set(covers.map((name) => PLAYS[name]))) {
    const why = check(claimOf(level, about, maxTime, play), certificate);
    if (why !== null) return wrong(why);
  }
  return { ok: true };
}

// what can be seen at time 0 needs no time
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
    case 'covered':
      return checkCovered(claim);
  }
}
