import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { applyPatches, createEditedLevel, diffFiles } from '../../editor/core/document/index.ts';
import { importLevels, LONGEST_LINK, levelFile, levelOf, linkTo, pictureSvg, slugOf } from '../../editor/core/exchange/index.ts';
import { createProver } from '../../editor/core/proof/index.ts';
import { TEMPLATES } from '../../editor/core/templates/index.ts';
import { surveyLink } from '../../editor/features/share/LinkedLevel.tsx';
import { DEFAULT_TERMS } from '../../engine/index.ts';
import { mergeLevels } from '../../review/index.ts';
import {
  enteringFolder,
  formatLevel,
  LEVEL_ID_PART,
  type LevelFile,
  leavingFolder,
  type OwnRules,
  RULE_NAMES,
  RULES,
  readLevel,
  resolveLevel,
  rulesOf,
  withIds,
} from '../../schema/index.ts';
import { itQuick } from '../depth.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const PAGE = 'https://example.org/editor/';
const firewalk = readFileSync(join(dirname(fileURLToPath(import.meta.url)), '../../levels/16-firewalk.level.json'), 'utf8');
const fileOf = (text: string): LevelFile => {
  const reading = readLevel(text);
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return withIds(reading.document.file);
};

const arbitraryRules: fc.Arbitrary<OwnRules> = fc.record(
  Object.fromEntries(
    RULE_NAMES.map((name) => [name, fc.constantFrom(RULES[name].default, RULES[name].least, RULES[name].most, undefined)]),
  ),
);

describe('a level that leaves or enters a folder', () => {
  it('keeps its rules, and only rules that the folder sets are written', () => {
    fc.assert(
      fc.property(arbitraryFile, arbitraryRules, (file, folder) => {
        const left = leavingFolder(file, folder);
        expect(rulesOf(resolveLevel(left))).toEqual(rulesOf(resolveLevel(file, folder)));
        const come = enteringFolder(file, folder);
        expect(rulesOf(resolveLevel(come, folder))).toEqual(rulesOf(resolveLevel(file)));
        for (const moved of [left, come]) {
          const reading = readLevel(formatLevel(moved));
          expect(reading.ok && reading.document.file).toEqual(moved);
          expect({ ...moved, rules: file.rules }).toEqual(file);
          expect(moved.rules ?? {}).toMatchObject(file.rules ?? {});
          for (const name of RULE_NAMES) if (folder[name] === undefined) expect(moved.rules?.[name]).toBe(file.rules?.[name]);
        }
        // a second time changes nothing, nor does a folder without rules
        expect(leavingFolder(left, folder)).toBe(left);
        expect(enteringFolder(come, folder)).toBe(come);
        expect(leavingFolder(file, {})).toBe(file);
        expect(enteringFolder(file, {})).toBe(file);
      }),
    );
  });
});

describe('a link', () => {
  it('contains any small level, which reads back the same', async () => {
    await fc.assert(
      fc.asyncProperty(arbitraryFile, async (file) => {
        const link = await linkTo(file, DEFAULT_TERMS, PAGE);
        if (!link.ok) throw new Error(link.message);
        expect(link.url).toMatch(/^https:\/\/example\.org\/editor\/#level=[\w-]+&accuracy=precise&max-time=60$/);
        const linked = await levelOf(new URL(link.url).hash);
        expect(linked).toMatchObject({ ok: true });
        if (linked?.ok) expect(formatLevel(linked.file)).toBe(formatLevel(file));
      }),
      { numRuns: 50 },
    );
  });

  it('is refused if the level is too large for a link in a chat program', async () => {
    const novae = Array.from({ length: 2000 }, (_, i) => ({ x: Math.sin(i) * 1e6, y: Math.cos(i) * 1e6, radius: 16 }));
    expect(await linkTo({ ...fileOf(firewalk), novae }, DEFAULT_TERMS, PAGE)).toMatchObject({
      ok: false,
      message: expect.stringContaining(String(LONGEST_LINK)),
    });
  });

  it.each(['#level=', '#level=!!!', '#level=AAAA', '#token=x&level=abc'])('is reported as damaged: %s', async (fragment) => {
    expect(await levelOf(fragment)).toMatchObject({ ok: false, message: expect.stringContaining('damaged') });
  });

  it('is reported with its problem if it does not contain a level', async () => {
    const { url } = (await linkTo(fileOf(firewalk), DEFAULT_TERMS, PAGE)) as { url: string };
    expect(await levelOf('#token=abc')).toBeNull();
    expect(await levelOf('')).toBeNull();
    expect(await levelOf(url.slice(url.indexOf('#'), url.indexOf('&') - 20))).toMatchObject({ ok: false });
  });

  itQuick('does not unpack without limit', async () => {
    const zeros = new Blob([new Uint8Array(50_000_000)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const packed = Buffer.from(await new Response(zeros).arrayBuffer()).toString('base64url');
    expect(await levelOf(`#level=${packed}`)).toMatchObject({ ok: false });
  });
});

describe('importing', () => {
  it('reads a level file, and levels of the original game', () => {
    expect(importLevels(firewalk, '16-firewalk.level.json')).toMatchObject({
      ok: true,
      kind: 'level',
      levels: [{ slug: '16-firewalk' }],
    });
    const original = '[{"player":{"x":1,"y":2},"target":{"x":50,"y":2},"asteroids":[{"x":30,"y":9,"radius":"16"}]},{}]';
    const read = importLevels(original, 'levels.json');
    expect(read).toMatchObject({
      ok: true,
      kind: 'original',
      levels: [{ slug: 'level-00', file: { recoil: true } }],
      notes: [expect.any(String)],
    });
    const without = importLevels(original, 'levels.json', { recoil: false });
    expect(without.ok && without.levels[0].file.recoil).toBe(undefined);
  });

  it.each(['', '{', '{"version": 1}', '[{"player": 1}]'])('reports what is wrong with %s', (text) => {
    const read = importLevels(text, 'x.json');
    expect(!read.ok && read.problems[0].message).toMatch(/./);
  });

  it('gives files names that every system accepts', () => {
    expect(['07 Sling Shot!.level.json', 'Ünïcode.json', '???', `${'a'.repeat(200)}.json`, '-x-.json'].map(slugOf)).toEqual([
      '07-sling-shot',
      'uenicode',
      'level',
      'a'.repeat(60),
      'x',
    ]);
    expect(
      ['Böse', 'Bo\u0308se', 'STRASSE Straße', 'Blåbærgrød', 'Café à la crème', 'Łódź', '漢字', '½ Größe №3', 'ﬁx'].map(slugOf),
    ).toEqual([
      ...['boese', 'boese', 'strasse-strasse', 'blabaergroed', 'cafe-a-la-creme', 'lodz', 'level', '1-2-groesse-no3', 'fix'],
    ]);
    expect(slugOf('CON.json')).toBe('level-con');
    fc.assert(fc.property(fc.string(), (name) => LEVEL_ID_PART.test(slugOf(name))));
  });
});

describe('exporting', () => {
  it('gives a file that gq reads, and a picture with the run', async () => {
    const file = fileOf(firewalk);
    const { name, blob } = levelFile('world/16-firewalk', file);
    expect([name, await blob.text()]).toEqual(['16-firewalk.level.json', formatLevel(file)]);
    const proof = createProver().prove({ file, run: null, terms: DEFAULT_TERMS });
    const [withRun, without] = [true, false].map((withRun) => pictureSvg(proof, { theme: 'dark', width: 800, withRun }));
    expect(withRun.length).toBeGreaterThan(without.length);
  });
});

describe('templates', () => {
  it('are valid levels, the same for the same seed', () => {
    for (const { make, usesSeed } of TEMPLATES) {
      for (let seed = 0; seed < 50; seed++) {
        const file = make('New', seed);
        expect(readLevel(formatLevel(file))).toMatchObject({ ok: true, level: { name: 'New' } });
        expect(make('New', seed)).toEqual(file);
        expect(formatLevel(make('New', seed + 1)) !== formatLevel(file)).toBe(usesSeed);
      }
    }
  });

  it('are completable if they have a run, and have no problems at the start', () => {
    for (const { id, make } of TEMPLATES) {
      for (let seed = 0; seed < 20; seed++) {
        const { verdict, problems } = createProver().prove({ file: make('New', seed), run: null, terms: DEFAULT_TERMS });
        expect(verdict).toBe(id === 'first-swing' ? 'completable' : 'unproven');
        expect(problems.filter(({ code }) => code !== 'no-run')).toEqual([]);
      }
    }
  });

  it('place seven asteroids and three novae at random, 100 px from the border', () => {
    const thrown = TEMPLATES.find(({ id }) => id === 'random');
    for (let seed = 0; seed < 50; seed++) {
      const file = thrown?.make('New', seed) as LevelFile;
      expect([file.asteroids?.length, file.novae?.length, file.astronaut]).toEqual([7, 3, { x: 640, y: 360 }]);
      for (const { x, y } of [...(file.asteroids ?? []), ...(file.novae ?? [])]) {
        expect(x >= 100 && x <= 1180 && y >= 100 && y <= 620).toBe(true);
      }
    }
  });
});

describe('a malicious link', () => {
  const packed = async (text: string): Promise<string> => {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    return `#level=${Buffer.from(await new Response(stream).arrayBuffer()).toString('base64url')}`;
  };
  const LEVEL = '"version": 1, "name": "x", "astronaut": {"x": 0, "y": 0}, "blackHole": {"x": 300, "y": 0}';

  it.each([
    ['__proto__', `{${LEVEL}, "__proto__": {"polluted": 1}}`],
    ['constructor', `{${LEVEL}, "constructor": {"prototype": {"polluted": 1}}}`],
    ['prototypes within', `{${LEVEL}, "asteroids": [{"x": 1, "y": 1, "radius": 9, "__proto__": {"polluted": 1}}]}`],
  ])('is refused with a key that no level has: %s', async (_, text) => {
    expect(await levelOf(await packed(text))).toMatchObject({ ok: false, message: expect.stringContaining('no valid level') });
    expect(({} as { polluted?: unknown }).polluted).toBeUndefined();
  });

  it('changes no prototype by its extra keys, through editing, undo, patches and merging', async () => {
    const own = '"x-own": {"__proto__": {"polluted": 1}, "constructor": {"prototype": {"polluted": 2}}}';
    const linked = await levelOf(await packed(`{${LEVEL}, ${own}, "x-__proto__": {"polluted": 3}}`));
    if (linked?.ok !== true) throw new Error('it is a valid level');
    const level = createEditedLevel(linked.file);
    level.change('Own', (draft) => {
      (draft as unknown as Record<string, { a: number }>)['x-own'] = JSON.parse('{"__proto__": {"polluted": 4}, "a": 1}');
    });
    level.undo();
    level.redo();
    const merged = mergeLevels(linked.file, level.file(), { ...linked.file, name: 'other' });
    expect(applyPatches(linked.file, diffFiles(linked.file, merged.file))).toEqual(merged.file);
    const { polluted } = {} as { polluted?: unknown };
    expect([polluted, ([] as { polluted?: unknown }).polluted]).toEqual([undefined, undefined]);
    expect(Object.keys(Object.prototype)).toEqual([]);
  });

  it.each([
    ['brackets', `{${LEVEL}, "x-deep": ${'['.repeat(100_000)}${']'.repeat(100_000)}}`],
    ['objects', `{${LEVEL}, "x-deep": ${'{"a":'.repeat(100_000)}1${'}'.repeat(100_000)}}`],
    ['no end', `{${LEVEL}, "x-deep": ${'['.repeat(400_000)}`],
  ])('is refused with deep nesting: %s', async (_, text) => {
    expect(await levelOf(await packed(text))).toMatchObject({ ok: false });
  });

  it('is reported as damaged, whatever its characters are', async () => {
    await fc.assert(
      fc.asyncProperty(fc.string({ unit: 'binary', maxLength: 60 }), async (text) => {
        const linked = await levelOf(`#level=${text.replaceAll('&', '')}`);
        expect(linked).toMatchObject({ ok: false });
      }),
      { numRuns: 50 },
    );
  });

  it('with numbers at their limits is opened like any other', async () => {
    const far = { x: 1e9, y: -1e9 };
    const text = JSON.stringify({
      version: 1,
      name: 'Far',
      astronaut: { x: -1e9, y: 1e9, vx: 1000, vy: -1000 },
      blackHole: { ...far, radius: 1e9 },
      range: 1e9,
      asteroids: [{ x: 0, y: 0, radius: 0.001 }],
      repulsors: [{ ...far, radius: 1e9 }],
      aliens: [{ ...far, radius: 0.001 }],
      runs: [{ name: 'r', holds: [[0, 1]] }],
    });
    const linked = await levelOf(await packed(text));
    // the schema decides about the limits: here the level is either refused or complete
    if (linked?.ok !== true) {
      expect(linked).toMatchObject({ ok: false, message: expect.stringContaining('no valid level') });
      return;
    }
    expect(surveyLink(linked.file, text).warnings).toEqual([expect.stringContaining('px from the origin')]);
    const { run, margins } = createProver().prove({
      file: createEditedLevel(linked.file).file(),
      run: null,
      terms: DEFAULT_TERMS,
    });
    expect(run.way.count).toBeGreaterThan(0);
    expect(margins.speed.every(Number.isFinite)).toBe(true);
  });
});

describe('the content of a link', () => {
  it('is described in numbers, with a warning if there is much', () => {
    const file = fileOf(firewalk);
    const survey = surveyLink(file, formatLevel(file));
    expect(survey.counts).toMatch(/asteroids?, .*runs? with \d+ holds?$/);
    expect(survey.size).toMatch(/^[\d.]+ kB$/);
    expect(survey.warnings).toEqual([]);
    const aliens = Array.from({ length: 8000 }, (_, i) => ({ x: i, y: 0, radius: 4 }));
    const many = surveyLink({ ...file, aliens, runs: undefined }, 'x'.repeat(123_456));
    expect(many).toMatchObject({ counts: expect.stringMatching(/8,000 aliens.*no run$/), size: '123 kB' });
    expect(many.warnings).toEqual([expect.stringContaining('very many objects')]);
    const holds = Array.from({ length: 1500 }, (_, i): [number, number] => [4 * i, 4 * i + 1]);
    const runs = Array.from({ length: 400 }, (_, i) => ({ name: `r${i}`, holds }));
    expect(surveyLink({ ...file, runs }, '').warnings).toEqual([expect.stringContaining('very many runs')]);
    expect(surveyLink({ ...file, astronaut: { x: 2e6, y: 0 } }, '').warnings).toEqual([
      expect.stringContaining('px from the origin'),
    ]);
  });
});
