import { type AccuracyName, compile } from '../../engine/index.ts';
import {
  challengeFor,
  createPlayer,
  createVerifier,
  decodePlay,
  encodePlay,
  PLAY_VERDICTS,
  type Play,
  type PlayVerdict,
  type PlayVerifier,
  playOf,
} from '../../game/index.ts';
import type { Hold } from '../../schema/index.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { pack } from '../levels/shipped-pack.ts';
import { seeded } from '../scenes/index.ts';

const KEY = new TextEncoder().encode('the key of the attacked server');
const NOW = 1_000_000;
const MAX_WORK = 20_000;

interface Target {
  readonly verifier: PlayVerifier;
  readonly play: Play;
  readonly bytes: Uint8Array;
}

/** A play of each of some shipped runs: to the end, left and timed out, at every accuracy, with and without a challenge. */
function targets(): Target[] {
  return pack.slice(0, 12).flatMap(({ level }, i) => {
    const verifier = createVerifier(level, { accuracy: 'any' });
    const accuracy: AccuracyName = accuracyNames[i % accuracyNames.length];
    return [0, 400, 700].map((most) => {
      const player = createPlayer(compile(level, accuracy), { replay: level.runs[0].holds, maxTime: most === 700 ? 11 : 60 });
      while (player.ending === null && (most === 0 || player.tick < most)) player.advance(100 / 6);
      const play = playOf(player, challengeFor(KEY, verifier.hash, NOW + i));
      return { verifier, play, bytes: encodePlay(play) };
    });
  });
}

/** A whole number from 0 up to, but not including, `below`. */
type Random = (below: number) => number;

const splice = (bytes: Uint8Array, at: number, remove: number, insert: readonly number[]): Uint8Array =>
  Uint8Array.from([...bytes.subarray(0, at), ...insert, ...bytes.subarray(at + remove)]);

/** Changes of the bytes, without knowing what they mean. */
const BLIND: readonly ((bytes: Uint8Array, random: Random, other: Uint8Array) => Uint8Array)[] = [
  (bytes, random) => bytes.with(random(bytes.length), random(256)),
  (bytes, random) => {
    const at = random(bytes.length);
    return bytes.with(at, bytes[at] ^ (1 << random(8)));
  },
  // behind the hash of the level, where the meaning is
  (bytes, random) => {
    const at = 45 + random(bytes.length - 45);
    return bytes.with(at, bytes[at] + (random(2) === 0 ? 1 : -1));
  },
  (bytes, random) => bytes.subarray(0, random(bytes.length)),
  (bytes, random) =>
    splice(
      bytes,
      bytes.length,
      0,
      Array.from({ length: 1 + random(20) }, () => random(256)),
    ),
  (bytes, random) =>
    splice(
      bytes,
      45 + random(bytes.length - 45),
      random(3),
      Array.from({ length: random(3) }, () => random(256)),
    ),
  // a byte of a varint with a needless continuation
  (bytes, random) => {
    const at = 46 + random(bytes.length - 46);
    return splice(bytes, at, 1, [bytes[at] | 0x80, 0]);
  },
  (bytes, random, other) => {
    const at = random(Math.min(bytes.length, other.length));
    return Uint8Array.from([...bytes.subarray(0, at), ...other.subarray(at)]);
  },
  (bytes, random) => {
    const [a, b] = [45 + random(bytes.length - 45), 45 + random(bytes.length - 45)];
    return bytes.with(a, bytes[b]).with(b, bytes[a]);
  },
];

const shifted = (holds: readonly Hold[], random: Random, by: number): Hold[] => {
  const edges = holds.flat();
  if (edges.length === 0) return [];
  edges[random(edges.length)] += by;
  return Array.from({ length: edges.length / 2 }, (_, i) => [edges[2 * i], edges[2 * i + 1]] as const);
};

const step = (random: Random): number => (random(2) === 0 ? 1 : -1) * (1 + random(random(2) === 0 ? 2 : 300));

/** Changes of what a play says, by somebody who knows the format. */
const KNOWING: readonly ((play: Play, random: Random, other: Play) => Play)[] = [
  (play, random) => ({ ...play, holds: shifted(play.holds, random, step(random)) }),
  (play, random) => ({ ...play, holds: play.holds.filter((_, i) => i !== random(play.holds.length)) }),
  (play, random) => ({ ...play, claim: { ...play.claim, tick: Math.max(0, play.claim.tick + step(random)) } }),
  (play, random) => ({ ...play, claim: { ...play.claim, minerals: Math.max(0, play.claim.minerals + step(random)) } }),
  (play, random) => ({
    ...play,
    claim: { ...play.claim, outcome: (['completed', 'collided', 'lost', 'timeout', 'left'] as const)[random(5)] },
  }),
  (play, random) => ({ ...play, accuracy: accuracyNames[random(4)] }),
  (play) => ({ ...play, checkpoints: play.checkpoints.toReversed() }),
  (play, random) => ({
    ...play,
    checkpoints: play.checkpoints.slice(random(2)),
    claim: { ...play.claim, tick: play.claim.tick - 600 },
  }),
  (play, _, other) => ({ ...play, holds: other.holds.filter(([, release]) => release < play.claim.tick) }),
  (play, _, other) => ({ ...play, claim: other.claim, hash: other.hash, checkpoints: other.checkpoints }),
  (play, _, other) => ({ ...other, level: play.level }),
  (play, _, other) => ({ ...play, hash: other.hash }),
  (play, _, other) => ({ ...play, challenge: other.challenge }),
  // the inputs are cut off, and the claim stays
  (play, random) => ({ ...play, holds: play.holds.slice(0, random(play.holds.length + 1)) }),
];

function mutated(random: Random, target: Target, other: Target): Uint8Array {
  let { bytes } = target;
  if (random(2) === 0) {
    try {
      bytes = encodePlay(KNOWING[random(KNOWING.length)](target.play, random, other.play));
    } catch {
      // no play can say it
      bytes = target.bytes;
    }
    if (random(3) > 0) return bytes;
  }
  for (let n = 1 + random(3); n > 0; n--) if (bytes.length > 46) bytes = BLIND[random(BLIND.length)](bytes, random, other.bytes);
  return bytes;
}

/** Whether a play is what it says: by a player that goes tick by tick. */
function isTrue(play: Play, { level }: PlayVerifier): boolean {
  const { tick, outcome } = play.claim;
  const player = createPlayer(compile(level, play.accuracy), {
    replay: play.holds,
    maxTime: outcome === 'timeout' ? tick / 60 : 3600,
  });
  while (player.tick < tick && player.ending === null) player.advance(100 / 6);
  const { challenge } = play;
  const isGiven = challenge !== null && challengeFor(KEY, play.level, Number.parseInt(challenge.slice(0, 8), 16)) === challenge;
  return isGiven && Buffer.compare(encodePlay(playOf(player, challenge)), encodePlay(play)) === 0;
}

export interface AttackResult {
  /** How many files got each verdict. */
  readonly verdicts: Readonly<Record<PlayVerdict, number>>;
  /** Accepted files that differ from the one that they were made of, in meaning; each was played again tick by tick. */
  readonly acceptedOthers: number;
  /** What must never happen, in words. */
  readonly failures: readonly string[];
  readonly mostWork: number;
}

/** Verifies mutated plays, as a server does, and checks what it finds. */
export function attack(count: number, seed: number): AttackResult {
  const all = targets();
  const next = seeded(seed);
  const random: Random = (below) => Math.floor(next() * below);
  const verdicts = Object.fromEntries(PLAY_VERDICTS.map((verdict) => [verdict, 0])) as Record<PlayVerdict, number>;
  const failures: string[] = [];
  let acceptedOthers = 0;
  let mostWork = 0;
  const options = { challengeKey: KEY, now: NOW, maxWork: MAX_WORK };
  for (const { verifier, bytes } of all) {
    const { verdict, message } = verifier.verify(bytes, options);
    if (verdict !== 'ok') failures.push(`a play as it was recorded: ${verdict}: ${message}`);
  }
  for (let i = 0; i < count; i++) {
    const target = all[random(all.length)];
    const bytes = mutated(random, target, all[random(all.length)]);
    const fail = (what: string) => failures.push(`${what}: ${Buffer.from(bytes).toString('base64url')} (number ${i})`);
    try {
      const decoded = decodePlay(bytes);
      if (decoded.ok && Buffer.compare(encodePlay(decoded.play), bytes) !== 0) fail('a play with two forms');
      const { verdict, play, work } = target.verifier.verify(bytes, options);
      verdicts[verdict]++;
      mostWork = Math.max(mostWork, work);
      if (verdict !== 'ok' || play === null) continue;
      if (Buffer.compare(bytes, target.bytes) !== 0) acceptedOthers++;
      if (!isTrue(play, target.verifier)) fail('accepted, and not true');
    } catch (error) {
      fail(`thrown ${String(error)}`);
    }
  }
  return { verdicts, acceptedOthers, failures, mostWork };
}
