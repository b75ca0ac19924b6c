import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createProver } from '../../editor/proof/index.ts';
import { importText, LONGEST_LINK, levelFile, levelOf, linkTo, pictureSvg, slugOf } from '../../editor/share/index.ts';
import { TEMPLATES } from '../../editor/templates/index.ts';
import { formatLevel, LEVEL_ID_PART, type LevelFile, readLevel, withIds } from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const PAGE = 'https://example.org/editor/';
const firewalk = readFileSync(join(dirname(fileURLToPath(import.meta.url)), '../../levels/16-firewalk.level.json'), 'utf8');
const fileOf = (text: string): LevelFile => {
  const reading = readLevel(text);
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return withIds(reading.document.file);
};

describe('a link', () => {
  it('carries any small level there and back', async () => {
    await fc.assert(
      fc.asyncProperty(arbitraryFile, async (file) => {
        const link = await linkTo(file, PAGE);
        if (!link.ok) throw new Error(link.message);
        expect(link.url).toMatch(/^https:\/\/example\.org\/editor\/#level=[\w-]+$/);
        const linked = await levelOf(new URL(link.url).hash);
        expect(linked).toMatchObject({ ok: true });
        if (linked?.ok) expect(formatLevel(linked.file)).toBe(formatLevel(file));
      }),
      { numRuns: 50 },
    );
  });

  it('is refused for a level that it could not carry through a chat program', async () => {
    const novae = Array.from({ length: 2000 }, (_, i) => ({ x: Math.sin(i) * 1e6, y: Math.cos(i) * 1e6, radius: 16 }));
    expect(await linkTo({ ...fileOf(firewalk), novae }, PAGE)).toMatchObject({
      ok: false,
      message: expect.stringContaining(String(LONGEST_LINK)),
    });
  });

  it.each(['#level=', '#level=!!!', '#level=AAAA', '#token=x&level=abc'])('that is damaged says so: %s', async (fragment) => {
    expect(await levelOf(fragment)).toMatchObject({ ok: false, message: expect.stringContaining('damaged') });
  });

  it('that carries something else says what', async () => {
    const { url } = (await linkTo(fileOf(firewalk), PAGE)) as { url: string };
    expect(await levelOf('#token=abc')).toBeNull();
    expect(await levelOf('')).toBeNull();
    expect(await levelOf(url.slice(url.indexOf('#'), -20))).toMatchObject({ ok: false });
  });

  it('does not unpack without end', async () => {
    const zeros = new Blob([new Uint8Array(50_000_000)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const packed = Buffer.from(await new Response(zeros).arrayBuffer()).toString('base64url');
    expect(await levelOf(`#level=${packed}`)).toMatchObject({ ok: false });
  });
});

describe('importing', () => {
  it('reads a level file, and levels of the original game', () => {
    expect(importText(firewalk, '16-firewalk.level.json')).toMatchObject({
      ok: true,
      kind: 'level',
      levels: [{ slug: '16-firewalk' }],
    });
    const original = '[{"player":{"x":1,"y":2},"target":{"x":50,"y":2},"asteroids":[{"x":30,"y":9,"radius":"16"}]},{}]';
    const read = importText(original, 'levels.json');
    expect(read).toMatchObject({
      ok: true,
      kind: 'original',
      levels: [{ slug: 'level-00', file: { recoil: true } }],
      notes: [expect.any(String)],
    });
    const without = importText(original, 'levels.json', { recoil: false });
    expect(without.ok && without.levels[0].file.recoil).toBe(undefined);
  });

  it.each(['', '{', '{"version": 1}', '[{"player": 1}]'])('says what is wrong with %s', (text) => {
    const read = importText(text, 'x.json');
    expect(!read.ok && read.problems[0].message).toMatch(/./);
  });

  it('names files so that every system takes them', () => {
    expect(['07 Sling Shot!.level.json', 'Ünïcode.json', '???', `${'a'.repeat(200)}.json`, '-x-.json'].map(slugOf)).toEqual([
      '07-sling-shot',
      'u-ni-code',
      'level',
      'a'.repeat(60),
      'x',
    ]);
    expect(slugOf('CON.json')).toBe('level-con');
    fc.assert(fc.property(fc.string(), (name) => LEVEL_ID_PART.test(slugOf(name))));
  });
});

describe('exporting', () => {
  it('gives the file that gq reads, and a picture with the run', async () => {
    const file = fileOf(firewalk);
    const { name, blob } = levelFile('world/16-firewalk', file);
    expect([name, await blob.text()]).toEqual(['16-firewalk.level.json', formatLevel(file)]);
    const proof = createProver().prove({ file, run: null, accuracy: 'precise' });
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

  it('prove themselves where they have a run, and have nothing wrong at the start', () => {
    for (const { id, make } of TEMPLATES) {
      for (let seed = 0; seed < 20; seed++) {
        const { verdict, problems } = createProver().prove({ file: make('New', seed), run: null, accuracy: 'precise' });
        expect(verdict).toBe(id === 'first-swing' ? 'completable' : 'unproven');
        expect(problems.filter(({ code }) => code !== 'no-run')).toEqual([]);
      }
    }
  });

  it('throw seven asteroids and three novae, 100 px from the border', () => {
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
