import { hexToBytes } from '@noble/hashes/utils.js';
import {
  ACCURACY_CODES,
  CHALLENGE_BYTES,
  checkpointCount,
  ENGINE_BYTES,
  FORMAT_VERSION,
  HASH_BYTES,
  LEVEL_BYTES,
  MAGIC,
  OUTCOME_CODES,
  PLAY_LIMITS,
} from './format.ts';
import type { Play } from './play.ts';

/** Values from 0 up to this can be written: four bytes of seven bits. */
export const MOST_VARINT = 0xfff_ffff;

function expect(isAsExpected: boolean, what: string, expected: string, found: unknown): void {
  if (!isAsExpected) throw new RangeError(`${what}: expected ${expected}, found ${String(found)}`);
}

const isCount = (value: number, most: number): boolean => Number.isInteger(value) && value >= 0 && value <= most;

function hex(text: string, bytes: number, what: string): Uint8Array {
  const isHex = typeof text === 'string' && text.length === 2 * bytes && /^[0-9a-f]*$/.test(text);
  expect(isHex, what, `${2 * bytes} hexadecimal digits, lower case`, text);
  return hexToBytes(text);
}

function varint(value: number): number[] {
  const bytes: number[] = [];
  let rest = value;
  for (; rest > 0x7f; rest >>= 7) bytes.push((rest & 0x7f) | 0x80);
  bytes.push(rest);
  return bytes;
}

/** The ticks at which the button changed. A release at the end of the play is none. */
function edgesOf({ holds, claim: { tick } }: Play): number[] {
  const edges: number[] = [];
  for (const [i, [press, release]] of holds.entries()) {
    const least = i === 0 ? 0 : holds[i - 1][1] + 1;
    const what = `holds: number ${i + 1}`;
    const isWhole = Number.isInteger(press) && Number.isInteger(release);
    expect(isWhole && press >= least, what, `a press at a whole tick from ${least} on`, press);
    expect(release > press && release <= tick, what, `a release after tick ${press} and up to the end at ${tick}`, release);
    edges.push(press);
    if (release < tick) edges.push(release);
  }
  return edges;
}

/**
 * Writes a play as the content of a `.gqr` file. A play has exactly one form.
 *
 * @param play - the play
 * @returns the bytes, usually some 100 to 200
 * @throws {RangeError} when the play has a value that no play can have; the message names it
 */
export function encodePlay(play: Play): Uint8Array {
  const { claim, challenge, checkpoints } = play;
  expect(isCount(claim.tick, PLAY_LIMITS.ticks), 'claim.tick', `a whole number from 0 to ${PLAY_LIMITS.ticks}`, claim.tick);
  expect(isCount(claim.minerals, MOST_VARINT), 'claim.minerals', `a whole number from 0 to ${MOST_VARINT}`, claim.minerals);
  const accuracy = ACCURACY_CODES.indexOf(play.accuracy);
  expect(accuracy >= 0, 'accuracy', `one of ${ACCURACY_CODES.join(', ')}`, play.accuracy);
  const outcome = OUTCOME_CODES.indexOf(claim.outcome);
  expect(outcome >= 0, 'claim.outcome', `one of ${OUTCOME_CODES.join(', ')}`, claim.outcome);
  const count = checkpointCount(claim.tick, claim.outcome);
  expect(checkpoints.length === count, 'checkpoints', `${count} of them`, checkpoints.length);
  const edges = edgesOf(play);
  expect(edges.length <= PLAY_LIMITS.edges, 'holds', `at most ${PLAY_LIMITS.edges} presses and releases`, edges.length);
  return Uint8Array.from([
    ...MAGIC,
    FORMAT_VERSION,
    ...hex(play.engine, ENGINE_BYTES, 'engine'),
    ...hex(play.level, LEVEL_BYTES, 'level'),
    accuracy,
    ...(challenge === null ? [0] : [CHALLENGE_BYTES, ...hex(challenge, CHALLENGE_BYTES, 'challenge')]),
    ...varint(edges.length),
    ...edges.flatMap((edge, i) => varint(i === 0 ? edge : edge - edges[i - 1])),
    ...varint(claim.tick),
    ...varint(claim.minerals),
    outcome,
    ...hex(play.hash, HASH_BYTES, 'hash'),
    ...checkpoints.flatMap((checkpoint, i) => [...hex(checkpoint, HASH_BYTES, `checkpoints: number ${i + 1}`)]),
  ]);
}
