import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation } from '../../engine/index.ts';
import {
  challengeFor,
  createPlayer,
  createVerifier,
  decodePlay,
  ENGINE_ID,
  encodePlay,
  levelHash,
  PLAY_LIMITS,
  type Play,
  playFromText,
  playOf,
  playToText,
  verifyPlay,
} from '../../game/index.ts';
import {
  fieldsOf,
  formatLevel,
  KINDS,
  type Level,
  type LevelFile,
  OBJECT_KINDS,
  RULE_NAMES,
  RULES,
  readLevel,
  resolveLevel,
} from '../../schema/index.ts';
import { arbitraryLevel } from '../engine/arbitrary-level.ts';
import { pack, shipped } from '../levels/shipped-pack.ts';

const { level } = shipped('grand-tour');
const { level: other } = shipped('firewalk');

function played(of: Level, holds = of.runs[0].holds, most = 3600): Play {
  const player = createPlayer(of, { replay: holds });
  while (player.ending === null && player.tick < most) player.advance(100 / 6);
  return playOf(player);
}

const play = played(level);
const bytes = encodePlay(play);
/** Where the number of edges is: after magic, version, engine, level, accuracy and no challenge. */
const EDGES = 4 + 1 + 8 + 32 + 1 + 1;

/** The bytes with some of them replaced. */
const replaced = (at: number, count: number, ...by: number[]): Uint8Array =>
  Uint8Array.from([...bytes.subarray(0, at), ...by, ...bytes.subarray(at + count)]);

describe('files that no encoder writes', () => {
  it.each<[string, Uint8Array, string, string]>([
    [
      'nothing',
      new Uint8Array(),
      'malformed',
      'byte 0: expected a play, which begins with the bytes 89 47 51 52, found no bytes',
    ],
    ['text', new TextEncoder().encode('{"play"}'), 'malformed', 'found 7b22706c'],
    ['another version', replaced(4, 1, 2), 'unknown-engine', 'expected version 1 of the format, found 2'],
    [
      'another accuracy',
      replaced(45, 1, 4),
      'malformed',
      'byte 45: expected an accuracy, 0 to 3 for arcade, fast, standard, precise, found 4',
    ],
    ['a short challenge', replaced(46, 1, 15), 'malformed', 'expected a challenge of 0 or 16 bytes, found 15'],
    [
      'a long form',
      replaced(EDGES, 1, bytes[EDGES] | 0x80, 0),
      'malformed',
      'byte 47: expected the number of presses and releases in as few bytes as possible, found 2 bytes that end with 0',
    ],
    ['a number of five bytes', replaced(EDGES, 1, 0x80, 0x80, 0x80, 0x80, 1), 'malformed', 'in at most 4 bytes, found more'],
    [
      'two edges in one tick',
      replaced(EDGES + 2, 1, 0),
      'malformed',
      'press or release number 2 after the one before, found both in one tick',
    ],
    [
      'edges that are not there',
      replaced(EDGES, 1, 0xff, 0xff, 1),
      'malformed',
      'expected 32767 presses and releases, at least a byte each, found ',
    ],
    [
      'more edges than allowed',
      replaced(EDGES, 1, 0xff, 0xff, 0xff, 0x7f),
      'too-long',
      'expected at most 40000, found 268435455',
    ],
    ['an edge after an hour', replaced(EDGES + 1, 1, 0xff, 0xff, 0xff, 0x7f), 'too-long', 'expected a tick below 216000'],
    ['more bytes', Uint8Array.from([...bytes, 0]), 'malformed', 'expected the end of the play, found 1 more byte'],
    ['too many bytes', new Uint8Array(PLAY_LIMITS.bytes + 1), 'too-long', 'expected a play of at most 65536 bytes, found 65537'],
  ])('%s', (_, file, verdict, message) => {
    const decoded = decodePlay(file);
    expect(decoded).toMatchObject({ ok: false, verdict });
    expect(!decoded.ok && decoded.message).toContain(message);
    expect(verifyPlay(level, file)).toMatchObject({ verdict, play: null, work: 0 });
  });

  it('are refused at every length below the whole', () => {
    for (let length = 0; length < bytes.length; length++) {
      expect(decodePlay(bytes.subarray(0, length))).toMatchObject({ ok: false, verdict: 'malformed' });
    }
  });

  it('say no edge at or after the end', () => {
    const { holds, claim } = play;
    const [press] = holds[holds.length - 1];
    const cut = {
      ...play,
      claim: { ...claim, tick: press },
      checkpoints: play.checkpoints.slice(0, Math.floor((press - 1) / 600)),
    };
    expect(() => encodePlay(cut)).toThrow(/^holds: number \d+: expected a release after tick \d+ and up to the end/);
    // the last edge of a play that was left is at its end: written by hand
    const open = encodePlay({ ...played(level, [[0, 50]], 50) });
    expect(decodePlay(open)).toMatchObject({ ok: true, play: { holds: [[0, 50]] } });
    const edges = [2, 0, 50];
    const written = Uint8Array.from([...open.subarray(0, EDGES), ...edges, ...open.subarray(EDGES + 2)]);
    expect(decodePlay(written)).toMatchObject({
      ok: false,
      verdict: 'malformed',
      message: expect.stringContaining('expected no press or release at or after the end at tick 50, found one at tick 50'),
    });
  });
});

describe('claims that are not true', () => {
  const verdictOf = (change: Partial<Play>, of = level) => verifyPlay(of, encodePlay({ ...play, ...change }));
  const { claim, checkpoints } = play;
  const open = played(level, play.holds, 900);

  it.each<[string, Partial<Play>, string]>([
    ['a tick earlier', { claim: { ...claim, tick: claim.tick - 1 } }, `found left at tick ${claim.tick - 1}`],
    ['a tick later', { claim: { ...claim, tick: claim.tick + 1 } }, `found completed at tick ${claim.tick} `],
    [
      'one mineral more',
      { claim: { ...claim, minerals: claim.minerals + 1 } },
      `found completed at tick ${claim.tick} with ${claim.minerals} `,
    ],
    ['another outcome', { claim: { ...claim, outcome: 'lost' } }, 'expected lost at tick'],
    ['that it was left', { claim: { ...claim, outcome: 'left' } }, 'found completed at tick'],
    ['another hash', { hash: open.hash }, 'the replay differs from the play: first between tick 1200 and'],
    [
      'another checkpoint',
      { checkpoints: ['0123456789abcdef', ...checkpoints.slice(1)] },
      'first between tick 0 and 600 (0.00 s and 10.00 s)',
    ],
    [
      'a play that was left for one that timed out',
      { ...open, claim: { ...open.claim, outcome: 'timeout' } },
      'first between tick 600 and 900',
    ],
  ])('%s', (_, change, message) => {
    expect(claim.tick % 600).toBeGreaterThan(1);
    const found = verdictOf(change);
    expect(found.verdict).toBe('claim-differs');
    expect(found.message).toContain(message);
    expect(found.differs).toMatchObject({ from: expect.any(Number), to: expect.any(Number) });
  });

  it('of another level or engine are refused by name', () => {
    expect(verifyPlay(other, bytes)).toMatchObject({
      verdict: 'stale-level',
      message: `expected a play of level ${levelHash(other)}, found one of ${levelHash(level)}`,
      work: 0,
    });
    expect(verdictOf({ level: levelHash(other) }, other).verdict).toBe('claim-differs');
    expect(verdictOf({ engine: '00112233445566aa' })).toMatchObject({
      verdict: 'unknown-engine',
      message: `expected a play of engine ${ENGINE_ID}, found one of 00112233445566aa`,
      work: 0,
    });
  });

  it('are of another accuracy than is asked for, and of another than that at which they were played', () => {
    expect(verdictOf({ accuracy: 'fast' })).toMatchObject({
      verdict: 'other-accuracy',
      message: 'expected a play at the accuracy precise, found one at fast',
      found: null,
      work: 0,
    });
    for (const accuracy of ['fast', 'any'] as const) {
      expect(verifyPlay(level, encodePlay({ ...play, accuracy: 'fast' }), { accuracy })).toMatchObject({
        verdict: 'claim-differs',
        message: expect.stringContaining('the replay differs from the play: first between tick 0 and 600'),
      });
    }
    // whoever made the verifier decides, and a call of it may decide otherwise
    const verifier = createVerifier(level, { accuracy: 'arcade' });
    expect(verifier.verify(bytes).verdict).toBe('other-accuracy');
    expect(verifier.verify(bytes, { accuracy: 'precise' }).verdict).toBe('ok');
    expect(verifier.verify(bytes, { maxTicks: 10 }).verdict).toBe('other-accuracy');
  });

  it('have been found out only if they were replayed to the end', () => {
    expect(verdictOf({ hash: open.hash }).found).toEqual(claim);
    expect(verdictOf({ checkpoints: ['0123456789abcdef', ...checkpoints.slice(1)] }).found).toBeNull();
  });

  it('that cost too much are stopped', () => {
    expect(verifyPlay(level, bytes, { maxWork: 10 })).toMatchObject({ verdict: 'too-long', work: expect.any(Number) });
    expect(verifyPlay(level, bytes, { maxTicks: claim.tick })).toMatchObject({ verdict: 'ok' });
    expect(verifyPlay(level, bytes, { maxTicks: claim.tick - 1 })).toMatchObject({ verdict: 'too-long', work: 0 });
  });
});

describe('a play that ends', () => {
  const simple = (change: Partial<LevelFile>): Level =>
    resolveLevel({
      version: 1,
      name: 'x',
      range: 1000,
      astronaut: { x: 0, y: 0, vx: 60 },
      blackHole: { x: 88, y: 0 },
      asteroids: [{ x: 0, y: 300, radius: 16 }],
      ...change,
    });

  it('between two ticks has one end only', () => {
    // she touches it so little before a tick that a simulation that is advanced further at once counts a tick more
    const level = simple({ blackHole: { x: 88 - 1e-10, y: 0 } });
    const ended = played(level, []);
    expect(ended.claim).toMatchObject({ outcome: 'completed' });
    expect([ended.claim.tick, createSimulation(compile(level)).advance(3600, false)]).toEqual([60, 61]);
    expect(verifyPlay(level, encodePlay(ended)).verdict).toBe('ok');
    for (const tick of [-1, 1, 2]) {
      const moved = { ...ended, claim: { ...ended.claim, tick: ended.claim.tick + tick } };
      const { verdict, found } = verifyPlay(level, encodePlay(moved));
      expect(verdict).toBe('claim-differs');
      if (tick === 1) expect(found).toEqual(ended.claim);
    }
  });

  it('at once, or is left before it began', () => {
    const inside = simple({ blackHole: { x: 5, y: 0 } });
    for (const most of [0, 3600]) {
      const at = played(inside, [[0, 9]], most);
      expect(verifyPlay(inside, encodePlay(at)).verdict).toBe('ok');
    }
    const unplayed = played(level, [], 0);
    expect(unplayed).toMatchObject({ claim: { tick: 0, outcome: 'left' }, holds: [] });
    expect(verifyPlay(level, encodePlay(unplayed)).verdict).toBe('ok');
  });
});

describe('signs', () => {
  it('are reported and reject nothing', () => {
    expect(verifyPlay(level, bytes)).toMatchObject({ verdict: 'ok', signs: { fastEdges: 0, publishedRun: level.runs[0].name } });
    const fast = played(
      level,
      [
        [10, 11],
        [12, 40],
        [41, 42],
        [60, 70],
      ],
      60,
    );
    expect(verifyPlay(level, encodePlay(fast))).toMatchObject({ verdict: 'ok', signs: { fastEdges: 4, publishedRun: null } });
    // the end of the play is no release
    const cut = played(level, [[59, 70]], 60);
    expect(cut.holds).toEqual([[59, 60]]);
    expect(verifyPlay(level, encodePlay(cut))).toMatchObject({ verdict: 'ok', signs: { fastEdges: 0, publishedRun: null } });
  });
});

describe('challenges', () => {
  const key = new TextEncoder().encode('sixteen bytes or more');
  const hash = levelHash(level);

  it('are 4 bytes of time and 12 of an HMAC over time, level and player', () => {
    const challenge = challengeFor(key, hash, 0x01020304, 'ann');
    expect(challenge).toMatch(/^01020304[0-9a-f]{24}$/);
    const all = [challenge, challengeFor(key, hash, 0x01020304), challengeFor(key, levelHash(other), 0x01020304, 'ann')];
    all.push(challengeFor(key, hash, 0x01020305, 'ann'), challengeFor(key.subarray(1), hash, 0x01020304, 'ann'));
    expect(new Set(all.map((text) => text.slice(8))).size).toBe(all.length);
  });

  it('are refused for what can not be written', () => {
    expect(() => challengeFor(key, hash, 1.5)).toThrow('expected an expiry in whole seconds since 1970, found 1.5');
    expect(() => challengeFor(key, hash, 2 ** 32)).toThrow('expected an expiry');
    expect(() => challengeFor(key, 'x', 1)).toThrow('expected the hash of a level');
    expect(() => verifyPlay(level, bytes, { challengeKey: key })).toThrow('expected the present time as "now"');
    // a secret that is not set is often an empty text, and anybody can sign with that
    for (const short of [new Uint8Array(), key.subarray(0, 15)]) {
      const message = `expected a key of at least 16 bytes, found ${short.length}`;
      expect(() => challengeFor(short, hash, 1)).toThrow(`challengeFor: ${message}`);
      expect(() => verifyPlay(level, bytes, { challengeKey: short, now: 1 })).toThrow(`verifyPlay: ${message}`);
    }
    expect(challengeFor(key.subarray(0, 16), hash, 1)).toMatch(/^00000001/);
  });

  it('are missed where there is none', () => {
    const asked = { challengeKey: key, now: 1000 };
    expect(verifyPlay(level, bytes, asked)).toMatchObject({ verdict: 'claim-differs', challenge: 'missing', work: 0 });
    expect(verifyPlay(level, bytes)).toMatchObject({ verdict: 'ok', challenge: 'none' });
  });

  it('fail when any bit of them is another', () => {
    const challenged = encodePlay({ ...play, challenge: challengeFor(key, hash, 1000) });
    const options = { challengeKey: key, now: 1000 };
    expect(verifyPlay(level, challenged, options)).toMatchObject({ verdict: 'ok', challenge: 'ok' });
    expect(verifyPlay(level, challenged, { ...options, now: 1001 })).toMatchObject({
      verdict: 'claim-differs',
      challenge: 'expired',
    });
    for (let bit = 0; bit < 128; bit++) {
      const changed = challenged.slice();
      changed[47 + (bit >> 3)] ^= 1 << (bit & 7);
      expect(verifyPlay(level, changed, options)).toMatchObject({ verdict: 'claim-differs', challenge: 'forged', work: 0 });
    }
  });
});

describe('the text of a play', () => {
  it('is base64url, and bytes have one text', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 80 }), (any) => {
        const text = playToText(any);
        expect(text).toBe(Buffer.from(any).toString('base64url'));
        expect(playFromText(`\n ${text}\t`)).toEqual(any);
      }),
    );
    for (const text of ['A', 'AB', 'AAB', 'AA==', 'A+BC', 'ä', 'AAAA AAAA', 'A'.repeat(90_000)]) {
      expect(text.length > 5 ? playFromText(text) : [text, playFromText(text)]).toEqual(text.length > 5 ? null : [text, null]);
    }
    expect(playFromText('')).toEqual(new Uint8Array());
  });
});

describe('the hash of a level', () => {
  const hashOf = (file: object): string => levelHash(resolveLevel(file as LevelFile));
  const { file } = shipped('grand-tour');

  it('is the same whatever the names, ids, texts, runs and keys of one’s own are', () => {
    fc.assert(
      fc.property(arbitraryLevel, (of) => {
        const nameless = JSON.parse(JSON.stringify(of), (key, value) => (key === 'id' ? null : value)) as Level;
        expect(levelHash({ ...nameless, name: 'y', description: 'z', runs: [], allow: { 'no-run': 'x' } as never })).toBe(
          levelHash(of),
        );
        expect(levelHash({ ...of, astronaut: { ...of.astronaut, vx: of.astronaut.vx === 0 ? -0 : of.astronaut.vx } })).toBe(
          levelHash(of),
        );
      }),
      { numRuns: 50 },
    );
    for (const { text } of pack) {
      const read = readLevel(text);
      if (!read.ok) throw new Error('expected a valid level');
      const again = readLevel(formatLevel({ ...read.document.file, 'x-mine': 1 } as LevelFile));
      expect(again.ok && levelHash(again.level)).toBe(levelHash(read.level));
    }
  });

  it('is another one when any field of any kind, the order, the range, the recoil or a rule is another', () => {
    const objects = OBJECT_KINDS.map((kind) => {
      const values = Object.fromEntries(fieldsOf(kind).map(([name, field]) => [name, field.type === 'number' ? 30 : true]));
      return [KINDS[kind].list ?? kind, KINDS[kind].list === null ? values : [values, { ...values, x: 40 }]] as const;
    });
    const full = { version: 1, name: 'x', ...Object.fromEntries(objects) };
    const hashes = [hashOf(full), hashOf({ ...full, range: 500 }), hashOf({ ...full, recoil: true })];
    for (const kind of OBJECT_KINDS) {
      const { list } = KINDS[kind];
      const value = full[(list ?? kind) as keyof typeof full] as never as Record<string, unknown> & unknown[];
      for (const [name, field] of fieldsOf(kind)) {
        const changed = field.type === 'number' ? 31 : false;
        hashes.push(
          hashOf({
            ...full,
            [list ?? kind]:
              list === null ? { ...value, [name]: changed } : [{ ...(value[0] as object), [name]: changed }, value[1]],
          }),
        );
      }
      if (list !== null)
        hashes.push(
          hashOf({ ...full, [list]: [value[1], value[0]] }),
          hashOf({ ...full, [list]: [value[0]] }),
          hashOf({ ...full, [list]: [] }),
        );
    }
    for (const name of RULE_NAMES) hashes.push(hashOf({ ...full, rules: { [name]: RULES[name].default + 1 } }));
    expect(new Set(hashes).size).toBe(hashes.length);
    expect(hashes.length).toBeGreaterThan(60);
  });

  it('is the same when a file says what it could leave out, and stays as it was published', () => {
    expect(hashOf({ ...file, rules: { pull: RULES.pull.default } })).toBe(hashOf(file));
    expect(hashOf({ ...file, winds: [], recoil: file.recoil ?? false })).toBe(hashOf(file));
    const plain = { version: 1, name: 'x', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 200 } };
    expect(hashOf({ ...plain, asteroids: [{ x: 1, y: 2, radius: 16 }] })).toMatchInlineSnapshot(
      `"9b3c567acb9cd3c112098691d497ba305c33446c4fac667b9eebf0851158dec2"`,
    );
  });
});
