import { hmac } from '@noble/hashes/hmac.js';
import { sha256 } from '@noble/hashes/sha2.js';
import { bytesToHex, concatBytes, hexToBytes, utf8ToBytes } from '@noble/hashes/utils.js';

/** Bytes of the time at which a challenge expires, and of the tag that proves who made it. */
const EXPIRY_BYTES = 4;
const TAG_BYTES = 12;

/** A shorter key could be guessed. */
const SHORTEST_KEY = 16;

/** What a challenge is worth. */
export type ChallengeState =
  /** The play has none, and none was asked for. */
  | 'none'
  /** The play has one, and no key to check it with was given. */
  | 'unchecked'
  /** It was given by the key for this level and player, and holds. */
  | 'ok'
  /** The play has none, though one was asked for. */
  | 'missing'
  /** It was not given by this key for this level and player. */
  | 'forged'
  /** It was given, and its time is over. */
  | 'expired';

/** @throws {RangeError} when a key is too short to be a secret, such as one that was not set */
export function expectSecret(key: Uint8Array, caller: string): void {
  if (key.length >= SHORTEST_KEY) return;
  throw new RangeError(`${caller}: expected a key of at least ${SHORTEST_KEY} bytes, found ${key.length}`);
}

/** The tag of a challenge: it covers when it expires, for which level it is, and for which player. */
function tagOf(key: Uint8Array, expiry: Uint8Array, level: string, subject: string): Uint8Array {
  const content = concatBytes(utf8ToBytes('gravity-quest challenge\n'), expiry, hexToBytes(level), utf8ToBytes(subject));
  return hmac(sha256, key, content).subarray(0, TAG_BYTES);
}

/**
 * Makes a challenge, which a server gives a player before the play. The play contains it, so that the server later knows that
 * it gave it, without keeping anything: 4 bytes for when it expires, and 12 bytes of an HMAC-SHA-256.
 *
 * @param key - the server's secret, at least 16 random bytes
 * @param level - the hash of the level, from `levelHash`
 * @param expiry - when it ends to be valid, whole seconds since 1970
 * @param subject - for whom it is, such as an account; '' for anybody
 * @returns the challenge, 32 hexadecimal digits
 * @throws {RangeError} when the key is too short, the level no hash, or the expiry no time that can be written
 */
export function challengeFor(key: Uint8Array, level: string, expiry: number, subject = ''): string {
  expectSecret(key, 'challengeFor');
  if (!Number.isInteger(expiry) || expiry < 0 || expiry > 0xffff_ffff) {
    throw new RangeError(`challengeFor: expected an expiry in whole seconds since 1970, found ${expiry}`);
  }
  if (!/^[0-9a-f]{64}$/.test(level)) {
    throw new RangeError(`challengeFor: expected the hash of a level, 64 hexadecimal digits, found ${level}`);
  }
  const time = new Uint8Array(EXPIRY_BYTES);
  new DataView(time.buffer).setUint32(0, expiry);
  return bytesToHex(concatBytes(time, tagOf(key, time, level, subject)));
}

/** What is asked of challenges. */
export interface ChallengeCheck {
  /** The server's secret, as it was given to {@link challengeFor}. */
  readonly key: Uint8Array;
  /** The present time, whole seconds since 1970. */
  readonly now: number;
  /** For whom it must be; '' when left out. */
  readonly subject?: string;
}

/** What the challenge of a play on a level is worth. */
export function challengeState(challenge: string | null, level: string, check: ChallengeCheck | null): ChallengeState {
  if (check === null) return challenge === null ? 'none' : 'unchecked';
  if (challenge === null) return 'missing';
  const bytes = hexToBytes(challenge);
  const time = bytes.subarray(0, EXPIRY_BYTES);
  const tag = tagOf(check.key, time, level, check.subject ?? '');
  // the time that this takes says nothing about the tag
  let difference = 0;
  for (let i = 0; i < TAG_BYTES; i++) difference |= tag[i] ^ bytes[EXPIRY_BYTES + i];
  if (difference !== 0) return 'forged';
  const expiry = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0);
  return check.now <= expiry ? 'ok' : 'expired';
}
