import { bytesToHex, hexToBytes } from '@noble/hashes/utils.js';
import { pointerFile } from '../../schema/json/index.ts';
import { holdsOf } from '../player/index.ts';
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
  type Play,
} from './play.ts';

/** Values from 0 up to this can be written: four bytes of seven bits. */
const MOST_VARINT = 0xfff_ffff;

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

/** Why bytes are not a play that can be read. */
export type Unreadable = 'malformed' | 'too-long' | 'unknown-engine';

/** What {@link decodePlay} gives. */
export type DecodedPlay =
  | {
      /** The bytes are a play. */
      readonly ok: true;
      /** The play. */
      readonly play: Play;
    }
  | {
      /** The bytes can't be read. */
      readonly ok: false;
      /**
       * `malformed`: they are no play. `too-long`: they are more than a play can have. `unknown-engine`: they have another version
       * of the format.
       */
      readonly verdict: Unreadable;
      /** What was expected and what was found, and at which byte. */
      readonly message: string;
    };

/** Bytes of a varint: what is longer is larger than anything in a play. */
const MOST_VARINT_BYTES = 4;

class Refusal extends Error {
  constructor(
    readonly verdict: Unreadable,
    message: string,
  ) {
    super(message);
  }
}

class Reader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get rest(): number {
    return this.bytes.length - this.at;
  }

  /** @throws Refusal that names the byte before the present one */
  refuse(expected: string, found: string): never {
    throw new Refusal('malformed', `byte ${this.at}: expected ${expected}, found ${found}`);
  }

  take(count: number, what: string): Uint8Array {
    if (this.rest < count) {
      const found = this.rest === 0 ? 'the end' : `only ${this.rest} byte${this.rest === 1 ? '' : 's'}`;
      this.refuse(`${what}, ${count} byte${count === 1 ? '' : 's'}`, `${found}: the file is cut off`);
    }
    this.at += count;
    return this.bytes.subarray(this.at - count, this.at);
  }

  hex(count: number, what: string): string {
    return bytesToHex(this.take(count, what));
  }

  /** A byte that is one of the names. */
  oneOf<T extends string>(names: readonly T[], what: string): T {
    const [code] = this.take(1, what);
    if (code < names.length) return names[code];
    this.at--;
    return this.refuse(`${what}, 0 to ${names.length - 1} for ${names.join(', ')}`, String(code));
  }

  /** A number in groups of seven bits, the lowest first; the eighth bit says that another follows. */
  varint(what: string, most = Number.POSITIVE_INFINITY): number {
    const start = this.at;
    let value = 0;
    for (let i = 0; ; i++) {
      const [byte] = this.take(1, what);
      value |= (byte & 0x7f) << (7 * i);
      if (byte < 0x80) {
        if (byte === 0 && i > 0) {
          this.at = start;
          this.refuse(`${what} in as few bytes as possible`, `${i + 1} bytes that end with 0`);
        }
        break;
      }
      if (i + 1 === MOST_VARINT_BYTES) {
        this.at = start;
        this.refuse(`${what} in at most ${MOST_VARINT_BYTES} bytes`, 'more');
      }
    }
    if (value > most) throw new Refusal('too-long', `${what}: expected at most ${most}, found ${value}`);
    return value;
  }
}

function readEdges(reader: Reader): number[] {
  const count = reader.varint('the number of presses and releases', PLAY_LIMITS.edges);
  if (count > reader.rest) reader.refuse(`${count} presses and releases, at least a byte each`, `${reader.rest} bytes`);
  const edges: number[] = [];
  let tick = 0;
  for (let i = 0; i < count; i++) {
    const difference = reader.varint(`press or release number ${i + 1}`);
    if (i > 0 && difference === 0) reader.refuse(`press or release number ${i + 1} after the one before`, 'both in one tick');
    tick += difference;
    if (tick >= PLAY_LIMITS.ticks) {
      throw new Refusal(
        'too-long',
        `press or release number ${i + 1}: expected a tick below ${PLAY_LIMITS.ticks}, found ${tick}`,
      );
    }
    edges.push(tick);
  }
  return edges;
}

function read(bytes: Uint8Array): Play {
  if (bytes.length > PLAY_LIMITS.bytes) {
    throw new Refusal('too-long', `expected a play of at most ${PLAY_LIMITS.bytes} bytes, found ${bytes.length}`);
  }
  const reader = new Reader(bytes);
  if (MAGIC.some((byte, i) => bytes[i] !== byte)) {
    const pointer = pointerFile(bytes);
    if (pointer !== null) reader.refuse('a play', `${pointer.found}. ${pointer.hint}`);
    reader.refuse(
      'a play, which begins with the bytes 89 47 51 52',
      bytes.length === 0 ? 'no bytes' : bytesToHex(bytes.subarray(0, 4)),
    );
  }
  reader.take(MAGIC.length, 'the beginning');
  const [version] = reader.take(1, 'the version of the format');
  if (version !== FORMAT_VERSION) {
    throw new Refusal(
      'unknown-engine',
      `expected version ${FORMAT_VERSION} of the format, found ${version}: the play needs another version of the toolkit`,
    );
  }
  const engine = reader.hex(ENGINE_BYTES, 'the identity of the engine');
  const level = reader.hex(LEVEL_BYTES, 'the hash of the level');
  const accuracy = reader.oneOf(ACCURACY_CODES, 'an accuracy');
  const [length] = reader.take(1, 'the length of the challenge');
  if (length !== 0 && length !== CHALLENGE_BYTES) reader.refuse(`a challenge of 0 or ${CHALLENGE_BYTES} bytes`, `${length}`);
  const challenge = length === 0 ? null : reader.hex(length, 'the challenge');
  const edges = readEdges(reader);
  const tick = reader.varint('the ticks of the claim', PLAY_LIMITS.ticks);
  if (edges.length > 0 && edges[edges.length - 1] >= tick) {
    reader.refuse(`no press or release at or after the end at tick ${tick}`, `one at tick ${edges[edges.length - 1]}`);
  }
  const minerals = reader.varint('the minerals of the claim');
  const outcome = reader.oneOf(OUTCOME_CODES, 'an outcome');
  const hash = reader.hex(HASH_BYTES, 'the hash of the play');
  const count = checkpointCount(tick, outcome);
  const checkpoints = Array.from({ length: count }, (_, i) => reader.hex(HASH_BYTES, `checkpoint ${i + 1} of ${count}`));
  if (reader.rest > 0) reader.refuse('the end of the play', `${reader.rest} more byte${reader.rest === 1 ? '' : 's'}`);
  return {
    engine,
    level,
    accuracy,
    challenge,
    holds: holdsOf(edges, tick),
    claim: { tick, minerals, outcome },
    hash,
    checkpoints,
  };
}

/**
 * Reads the content of a `.gqr` file. Whatever the bytes are, it neither throws nor allocates more than they justify. What the
 * play claims is not checked; `verifyPlay` does that.
 *
 * @param bytes - the content of the file
 * @returns the play, or why there is none
 */
export function decodePlay(bytes: Uint8Array): DecodedPlay {
  try {
    return { ok: true, play: read(bytes) };
  } catch (error) {
    if (!(error instanceof Refusal)) throw error;
    return { ok: false, verdict: error.verdict, message: error.message };
  }
}
