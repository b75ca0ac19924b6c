import { compile } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { type About, createSearch, type Orbits, type Proof, verifyProof } from '../../solver/index.ts';
import { seeded } from '../scenes/seeded.ts';
import { type FalseClaim, hugged, isFalse, somePoses, thingAt, trueTouches } from './claims.ts';
import { otherRules, ownRules } from './own-rules.ts';
import { playLevel, STYLES } from './plays.ts';
import { AWAY, levelFor } from './styles.ts';
import { withWindsAndWormholes } from './winds-and-wormholes.ts';

// A certificate of `orbits` is four numbers, so nobody needs a prover to forge one: the checker is asked directly.

/** Results of attacks on the checker of `orbits`. */
export interface OrbitsTally {
  levels: number;
  /** Levels in which some grid proves that every run ends, so that only the object matters. */
  ending: number;
  /** False claims, each with a run that touches the object. */
  claims: number;
  /** Levels that the checker accepted, and for which a search looked for a run. */
  searched: number;
  /** What was accepted although a run refutes it. */
  readonly wrong: { readonly seed: number; readonly level: Level; readonly about: About; readonly proof: Proof }[];
}

export const emptyOrbits = (): OrbitsTally => ({ levels: 0, ending: 0, claims: 0, searched: 0, wrong: [] });

/** How much is tried in one level. */
export interface OrbitsEffort {
  readonly grids: number;
  readonly plays: number;
  readonly ticks: number;
  /** Ticks of search against what is accepted; 0 for none. */
  readonly searchTicks: number;
}

const HOLE: About = { kind: 'blackHole' };

/** A certificate with some grid, from fine to absurdly coarse. */
function someOrbits(random: () => number): Orbits {
  const pick = (...of: number[]) => of[Math.floor(random() * of.length)];
  const place = pick(3, 4, 6, 10, 20, 50);
  const grid = {
    place,
    speed: place * pick(0.5, 1, 1, 3),
    momentum: place * pick(20, 50, 100, 300),
    frames: pick(2, 3, 4, 6, 12),
  };
  return { kind: 'orbits', grid, steps: pick(40, 60, 90) };
}

const proofOf = (certificate: Orbits, about: About, maxTime: number): Proof => ({
  code: 'orbits',
  about,
  reason: '',
  covers: ['precise'],
  maxTime,
  certificate,
});

/**
 * Attacks the checker in one level of the seed with claims that a run refutes. Half of the levels have rules of their own, a
 * quarter have winds and wormholes.
 */
export function attackOrbits(seed: number, { grids, plays, ticks, searchTicks }: OrbitsEffort, tally: OrbitsTally): void {
  const random = seeded(seed * 1013 + 5);
  const plain = levelFor('orbits', random);
  const ruled = seed % 2 === 1 ? { ...plain, rules: ownRules(random) } : plain;
  const level = seed % 4 === 2 ? withWindsAndWormholes(ruled, random) : ruled;
  const certificates = Array.from({ length: grids }, () => someOrbits(random));
  const accepts = (of: Level, about: About, certificate: Orbits) => verifyProof(of, proofOf(certificate, about, 60)).ok;
  tally.levels++;
  const ending = certificates.filter((one) => accepts({ ...level, blackHole: AWAY }, HOLE, one));
  if (ending.length > 0) tally.ending++;
  // Where runs go on, every certificate is refused for that, and few claims are enough.
  const [asked, most] = ending.length > 0 ? [ending, plays] : [certificates.slice(0, 1), 1];
  const ask = (claim: FalseClaim) => {
    tally.claims++;
    const certificate = asked[Math.floor(random() * asked.length)];
    if (accepts(claim.level, claim.about, certificate))
      tally.wrong.push({ seed, level: claim.level, about: claim.about, proof: proofOf(certificate, claim.about, 60) });
  };
  for (let n = 0; n < most; n++) {
    const play = playLevel(level, 'precise', STYLES[Math.floor(random() * STYLES.length)], random, ticks);
    const poses = somePoses(play, random, ending.length > 0 ? 8 : 2);
    const claims = trueTouches(
      level,
      'precise',
      play,
      poses.map((pose) => thingAt(level, pose, random)),
    );
    for (const claim of claims) ask(claim);
    for (const claim of claims.slice(0, 2)) {
      const { near } = hugged(claim, false, random);
      if (isFalse(near, 'precise')) ask(near);
      const other = { ...claim, level: otherRules(claim.level, random) };
      if (isFalse(other, 'precise')) ask(other);
    }
    if (searchTicks === 0 || ending.length === 0) continue;
    for (const pose of poses.slice(0, 2)) {
      // just beyond where she came, perhaps inside a nova
      const { x, y, radius } = thingAt(level, pose, random);
      const off = 1 + 0.5 * random();
      const blackHole = { id: null, x: pose.x + off * (x - pose.x), y: pose.y + off * (y - pose.y), radius };
      const of = { ...level, blackHole };
      const certificate = ending.find((one) => accepts(of, HOLE, one));
      if (certificate === undefined) continue;
      tally.searched++;
      const search = createSearch(compile(of), { seed });
      search.advance(searchTicks);
      if (search.solutions.length > 0) tally.wrong.push({ seed, level: of, about: HOLE, proof: proofOf(certificate, HOLE, 60) });
    }
  }
}
