import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { Attempt } from '../../editor/core/attempts/attempts.ts';
import { causeInWords } from '../../editor/core/attempts/index.ts';
import { groupPlays, refusedInWords } from '../../editor/core/plays/open-plays.ts';
import { playFileName } from '../../editor/core/plays/share-plays.ts';
import { isPlayText, playInFragment, playsInText, readPlayFiles } from '../../editor/core/shelf/given.ts';
import { createShelf, deathMapOf, deathsNear, type OpenedPlay, type Shelf } from '../../editor/core/shelf/shelf.ts';
import {
  type AttemptRow,
  attemptRows,
  type ListOptions,
  replayOf,
  SHOWN,
  SORTS,
} from '../../editor/features/attempts/attempt-rows.ts';
import { playsWork } from '../../editor/workers/jobs/plays.ts';
import { pathWork } from '../../editor/workers/jobs/trajectory.ts';
import { compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import { decodePlay, levelHash, PLAY_LIMITS, playToText } from '../../game/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { recordedPlay } from './recorded-play.ts';

/** She drifts downwards out of range; the gun pulls her past a hot asteroid into a nova. */
const FILE: LevelFile = {
  version: 1,
  name: 'Lane',
  astronaut: { x: 200, y: 304, vy: 20 },
  asteroids: [{ x: 420, y: 304, radius: 24, hot: true }],
  novae: [{ x: 240, y: 420, radius: 30 }],
  blackHole: { x: 300, y: 304 },
};
const LEVEL = resolveLevel(FILE);
const HIT = recordedPlay(FILE, [[20, 200]]);
const LOST = recordedPlay(FILE, []);
const LEFT = recordedPlay(FILE, [[20, 40]], 50);

/** Does a job at once. @param all receives what it reports */
function finish<T, R>(job: Generator<T, R>, all: T[] = []): R {
  for (;;) {
    const { done, value } = job.next();
    if (done) return value;
    if (value !== null) all.push(value);
  }
}

const verify = (plays: readonly Uint8Array[], known: readonly Replayed[] = [], first = 0) =>
  finish(playsWork.steps({ level: LEVEL, terms: DEFAULT_TERMS, plays, known, first }, () => 0));
type Replayed = NonNullable<OpenedPlay['replayed']>;

function opened(named: Readonly<Record<string, Uint8Array>>): OpenedPlay[] {
  const shelf = createShelf();
  const { plays, statistics } = verify(Object.values(named));
  const all = Object.entries(named).map(([source, bytes], i) => {
    const decoded = decodePlay(bytes);
    if (!decoded.ok) throw new Error(decoded.message);
    return { source, bytes, play: decoded.play, ...plays[i] };
  });
  return [...shelf.add(all, statistics, { level: LEVEL, hash: levelHash(LEVEL) })];
}

describe('what a person opens', () => {
  it('is a play as text, or a link to one, and nothing else that is pasted', () => {
    const text = playToText(HIT);
    expect(isPlayText(text)).toBe(true);
    expect(isPlayText(`  ${text}\n`)).toBe(true);
    expect(isPlayText(`https://example.org/play/#level=abc&play=${text}`)).toBe(true);
    for (const other of ['', '{"version":1}', 'https://example.org/#level=abc', 'play=', 'asteroid']) {
      expect(isPlayText(other)).toBe(false);
    }
    fc.assert(fc.property(fc.json(), (json) => !isPlayText(json)));
    expect(playInFragment(`#level=07&play=${text}`)).toBe(text);
    expect(playInFragment('#level=07&display=3')).toBeNull();
  });

  it('can be several plays, a line each; what is none is refused with its place', () => {
    const { plays, refused } = playsInText(`${playToText(HIT)}\nno+play\nhttps://a.b/#play=${playToText(LEFT)}`, 'the clipboard');
    expect(plays.map(({ name }) => name)).toEqual(['the clipboard, part 1', 'the clipboard, part 3']);
    expect(plays.map(({ bytes }) => bytes)).toEqual([HIT, LEFT]);
    expect(refused).toEqual([{ name: 'the clipboard, part 2', reason: expect.stringContaining('found “no+play”') }]);
  });

  it('is read from files; a file that is too large for a play is not', async () => {
    const large = new File([new Uint8Array(PLAY_LIMITS.bytes + 1)], 'large.gqr');
    const gone = Object.assign(new File([], 'gone.gqr'), { arrayBuffer: () => Promise.reject(new Error('gone')) });
    const { plays, refused } = await readPlayFiles([new File([new Uint8Array(HIT)], 'a.gqr'), large, gone]);
    expect(plays).toEqual([{ name: 'a.gqr', bytes: HIT }]);
    expect(refused.map(({ name }) => name)).toEqual(['large.gqr', 'gone.gqr']);
    expect(refused[0].reason).toBe('expected a play of at most 65536 bytes, found 65537');
    const many = Array.from({ length: 100 }, (_, i) => new File([new Uint8Array(HIT)], `${i}.gqr`));
    let asked = 0;
    expect((await readPlayFiles(many, () => ++asked > 2)).plays.length).toBeLessThan(100);
  });

  it('is grouped by level; what is malformed or of another engine is refused by name', () => {
    const other = recordedPlay({ ...FILE, range: 700 }, []);
    const engine = HIT.slice();
    engine[5] ^= 1;
    const { byLevel, refused } = groupPlays([
      { name: 'a', bytes: HIT },
      { name: 'b', bytes: other },
      { name: 'c', bytes: LEFT },
      { name: 'cut', bytes: HIT.subarray(0, 30) },
      { name: 'engine', bytes: engine },
    ]);
    expect(byLevel.get(levelHash(LEVEL))?.map(({ name }) => name)).toEqual(['a', 'c']);
    expect([...byLevel.values()].map(({ length }) => length)).toEqual([2, 1]);
    expect(refused.map(({ name, reason }) => `${name}: ${reason.slice(0, reason.indexOf(':'))}`)).toEqual([
      'cut: malformed',
      'engine: unknown-engine',
    ]);
    const many = Array.from({ length: 9 }, (_, i) => ({ name: `${i}`, reason: 'no play' }));
    expect(refusedInWords(many).split('\n')).toEqual(
      [...'0123'].map((i) => `${i}: no play.`).concat('5 more were refused as well.'),
    );
  });

  it('has a file name without characters that a system refuses', () => {
    expect(playFileName('Nova lane: part 2', 'attempt 3')).toBe('nova-lane-part-2-attempt-3.gqr');
    expect(playFileName('???', '../a\\b.GQR')).toBe('play-a-b.gqr');
    expect(playFileName('Böse', 'ann.gqr')).toBe('boese-ann.gqr');
  });
});

describe('verifying plays', () => {
  it('says what each turns out to be, and what they teach together, in however many parts they come', () => {
    const wrong = HIT.slice();
    wrong[wrong.length - 1] ^= 1;
    const all = [HIT, LOST, wrong, LEFT, HIT];
    const { plays, statistics } = verify(all);
    expect(plays.map(({ verdict, replayed }) => `${verdict} ${replayed?.outcome ?? '-'}`)).toEqual([
      'ok collided',
      'ok lost',
      'claim-differs -',
      'ok left',
      'ok collided',
    ]);
    expect(plays[0].replayed?.cause).toEqual({ kind: 'nova', index: 0 });
    expect(statistics.all.map(({ play }) => play)).toEqual([0, 1, 3, 4]);
    const begin = verify(all.slice(0, 2));
    expect(verify(all.slice(2), begin.statistics.all, 2).statistics).toEqual(statistics);
  });

  it('reports how many are done', () => {
    let now = 0;
    const told: unknown[] = [];
    const clock = () => {
      now += 60;
      return now;
    };
    finish(
      playsWork.steps({ level: LEVEL, terms: DEFAULT_TERMS, plays: [HIT, LOST, LEFT, HIT], known: [], first: 0 }, clock),
      told,
    );
    expect(told.length).toBeGreaterThan(0);
    expect(told).toContainEqual({ done: 2 });
  });

  it('follows a path to its last tick', () => {
    const holds: Hold[] = [[20, 200]];
    const run = simulate(compile(LEVEL, 'precise'), holds);
    const { points } = finish(pathWork.steps({ level: LEVEL, terms: DEFAULT_TERMS, holds, until: 10_000 }, () => 0));
    expect(points.length / 2).toBe(run.tick + 2);
    expect([points[0], points[1]]).toEqual([200, 304]);
    const short = finish(pathWork.steps({ level: LEVEL, terms: DEFAULT_TERMS, holds, until: 33 }, () => 0)).points;
    expect(short).toEqual(points.subarray(0, 2 * 34));
  });
});

describe('the opened plays of a level', () => {
  const of = { level: LEVEL, hash: levelHash(LEVEL) };
  const add = (shelf: Shelf, bytes: Uint8Array, to = of) => {
    const { plays, statistics } = verify([bytes]);
    const decoded = decodePlay(bytes);
    if (!decoded.ok) throw new Error(decoded.message);
    return shelf.add([{ source: 'file', bytes, play: decoded.play, ...plays[0] }], statistics, to)[0].key;
  };

  it('are each there once: neither the same file again nor twice at once; a false claim about the same holds is another', () => {
    const shelf = createShelf();
    add(shelf, HIT);
    const claim = HIT.slice();
    claim[claim.length - 1] ^= 1;
    const files = { known: HIT.slice(), claim, left: LEFT, again: LEFT.slice(), lost: LOST };
    const given = Object.entries(files).map(([name, bytes]) => ({ name, bytes }));
    expect(shelf.fresh(given).map(({ name }) => name)).toEqual(['claim', 'left', 'lost']);
    shelf.clear();
    expect(shelf.fresh(given).map(({ name }) => name)).toEqual(['known', 'claim', 'left', 'lost']);
  });

  it('stay until some of the level after a change are added; then none of the level before is left', () => {
    const shelf = createShelf();
    const keys = [add(shelf, HIT), add(shelf, LOST)];
    expect(shelf.store.getState().plays.map(({ key }) => key)).toEqual(keys);
    const changed = { ...of, hash: 'another' };
    const key = add(shelf, LEFT, changed);
    expect(keys).not.toContain(key);
    expect(shelf.store.getState()).toMatchObject({ plays: [{ key, bytes: LEFT }], of: changed, deaths: null });
  });
});

describe('the map of deaths', () => {
  const causes = [
    { kind: 'nova', index: 0 },
    { kind: 'nova', index: 2 },
    { kind: 'lost', index: null },
    { kind: 'timeout', index: null },
    { kind: 'left', index: null },
    null,
  ] as const;
  // sums of them have no rounding
  const quarter = fc.integer({ min: -8000, max: 8000 }).map((n) => n / 4);
  const attempts = fc.array(
    fc.record({
      x: quarter,
      y: quarter,
      cause: fc.constantFrom(...causes),
    }),
    { minLength: 1, maxLength: 60 },
  );
  const isDeath = ({ cause }: { cause: (typeof causes)[number] }) =>
    cause !== null && cause.kind !== 'timeout' && cause.kind !== 'left';

  it('counts each death in the square where it happens, and nothing else', () => {
    fc.assert(
      fc.property(attempts, (all) => {
        const map = deathMapOf(all);
        const dead = all.filter(isDeath);
        expect(map?.deaths ?? 0).toBe(dead.length);
        for (const { x, y, visits } of map?.cells ?? []) {
          const half = (map?.cellSize ?? 0) / 2;
          const inside = dead.filter((one) => one.x >= x - half && one.x < x + half && one.y >= y - half && one.y < y + half);
          expect(visits).toBe(inside.length);
        }
      }),
      { numRuns: 60 },
    );
  });

  it('finds those near a place by cause, as counting all of them does', () => {
    fc.assert(
      fc.property(attempts, fc.integer({ min: 1, max: 300 }), (all, reach) => {
        const map = deathMapOf(all);
        if (map === null) return;
        const { x, y } = all[0];
        const near = all.filter((one) => isDeath(one) && (one.x - x) ** 2 + (one.y - y) ** 2 <= reach ** 2);
        const found = deathsNear(map, x, y, reach);
        expect(found.reduce((sum, { count }) => sum + count, 0)).toBe(near.length);
        expect(found.map(({ count }) => count)).toEqual(found.map(({ count }) => count).sort((a, b) => b - a));
        for (const { cause, count } of found) {
          const kind = cause === 'is lost' ? 'lost' : 'nova';
          const index = kind === 'lost' ? null : Number(/\d+/.exec(cause)?.[0]) - 1;
          expect(count).toBe(near.filter((one) => one.cause?.kind === kind && one.cause.index === index).length);
        }
      }),
      { numRuns: 60 },
    );
  });
});

it('the map of deaths reaches exactly as far as it is asked to, and names what she dies of', () => {
  const death = (x: number, kind: 'lost' | 'alien') =>
    ({ x, y: 10, cause: kind === 'alien' ? { kind, index: 1 } : { kind, index: null } }) as const;
  const map = deathMapOf([death(50, 'lost'), death(50.25, 'alien'), death(-30, 'alien'), death(-30, 'alien')]);
  if (map === null) throw new Error('no deaths');
  expect(deathsNear(map, 10, 10, 40)).toEqual([
    { cause: 'hits alien 2', count: 2 },
    { cause: 'is lost', count: 1 },
  ]);
});

it.each([
  [{ kind: 'nova', index: 2 }, 'hits nova 3'],
  [{ kind: 'lost', index: null }, 'is lost'],
  [{ kind: 'timeout', index: null }, 'runs out of time'],
  [{ kind: 'left', index: null }, 'is left before the end'],
  [{ kind: 'minerals', index: null }, 'collects too few minerals'],
] as const)('the cause %o in words', (cause, words) => {
  expect(causeInWords(cause)).toBe(words);
});

describe('the list of attempts', () => {
  const attempt = (number: number, tick: number, outcome: 'completed' | 'lost' | null): Attempt => ({
    id: String(number),
    number,
    holds: [[0, 5]],
    end: outcome === null ? null : { outcome, with: null, time: tick / 60, tick },
    tick,
    minerals: number,
    accuracy: 'precise',
    points: new Float32Array(2),
    played: { bytes: HIT, hash: levelHash(LEVEL), file: FILE, rules: {} },
  });
  const attempts = [attempt(1, 90, 'lost'), attempt(2, 30, null), attempt(3, 600, 'completed')];
  const wrong = HIT.slice();
  wrong[wrong.length - 1] ^= 1;
  const plays = opened({ '2.gqr': HIT, '10.gqr': LEFT, 'wrong.gqr': wrong });
  const list = (options: Partial<ListOptions> = {}): AttemptRow[] =>
    attemptRows(attempts, plays, { sort: 'newest', shown: 'all', words: '', ...options }, LEVEL.range);
  const titles = (options: Partial<ListOptions>) => list(options).map(({ title }) => title);

  it('has the attempts of the session first, the latest first, and says how each ends', () => {
    expect(list().map(({ title, end }) => `${title}: ${end}`)).toEqual([
      'attempt 3: She reaches the black hole at 10.00 s.',
      'attempt 2: She was left at 0.50 s.',
      `attempt 1: She is lost at 1.50 s, farther than ${LEVEL.range} px from every asteroid.`,
      expect.stringMatching(/^wrong\.gqr: It claims to collide at 3\.\d\d s, but claim-differs\.$/),
      '10.gqr: She was left at 0.83 s.',
      expect.stringMatching(/^2\.gqr: She hits nova 1 at 3\.\d\d s\.$/),
    ]);
  });

  it('filters and sorts', () => {
    expect(titles({ shown: 'completed' })).toEqual(['attempt 3']);
    expect(titles({ shown: 'left' })).toEqual(['attempt 2', '10.gqr']);
    expect(titles({ shown: 'failed' })).toEqual(['attempt 1', '2.gqr']);
    expect(titles({ shown: 'differs' })).toEqual(['wrong.gqr']);
    expect(titles({ words: 'NOVA 1' })).toEqual(['2.gqr']);
    expect(titles({ shown: 'opened', sort: 'name' })).toEqual(['2.gqr', '10.gqr', 'wrong.gqr']);
    expect(titles({ shown: 'mine', sort: 'shortest' })).toEqual(['attempt 2', 'attempt 1', 'attempt 3']);
    expect(titles({ shown: 'mine', sort: 'longest' })).toEqual(['attempt 3', 'attempt 1', 'attempt 2']);
    expect(titles({ shown: 'mine', sort: 'oldest' })).toEqual(['attempt 1', 'attempt 2', 'attempt 3']);
    expect(titles({ shown: 'mine', sort: 'minerals' })).toEqual(['attempt 3', 'attempt 2', 'attempt 1']);
  });

  it('replays a row as it was played, and says so only if something that matters for it has changed since', () => {
    const hashOf = (changes: Partial<LevelFile>) => levelHash(resolveLevel({ ...FILE, ...changes }));
    const named = hashOf({ name: 'Renamed', runs: [{ name: 'kept', holds: [[0, 5]] }] });
    const moved = hashOf({ blackHole: { x: 301, y: 304 } });
    for (const row of list({ shown: 'failed' })) {
      const { title, holds, tick, end } = row;
      const replay = { title, holds, accuracy: 'precise', tick, end, look: 'lost' };
      expect(replayOf(row, named)).toEqual(replay);
      expect(replayOf(row, moved)).toEqual({ ...replay, end: expect.stringMatching(/^The level has changed since/) });
    }
    expect(list({ shown: 'completed' }).map((row) => replayOf(row, named).look)).toEqual(['won']);
  });

  it('shows every row once under "all" in every order, each where it says it is', () => {
    const keys = list().map(({ key }) => key);
    expect(new Set(keys).size).toBe(6);
    for (const sort of SORTS) {
      const rows = list({ sort });
      expect(rows.map(({ key }) => key).sort()).toEqual([...keys].sort());
      expect(rows.map(({ place, siblings }) => [place, siblings])).toEqual(rows.map((_, i) => [i, 6]));
    }
    // one of each kind
    expect(titles({ shown: 'opened' })).toHaveLength(3);
    for (const shown of SHOWN) expect(list({ shown }).every(({ key }) => keys.includes(key))).toBe(true);
  });
});
