import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { cacheFolder, chosenCache, semantics } from '../../cli/cache/index.ts';
import { DECIDING_PACKAGES, DECIDING_ROOMS } from '../../cli/cache/key.ts';
import { checkTogether } from '../../cli/check/check-level.ts';
import { type CheckedLevel, type CheckSettings, checkFiles, openLevelCache } from '../../cli/check/index.ts';
import { ANYWHERE } from '../../cli/check/level-cache.ts';
import { accuracyOf, DEFAULT_MAX_WORK } from '../../engine/index.ts';
import { MAX_FILE_SIZE, RULE_NAMES, RULES } from '../../schema/index.ts';
import { importGraph } from '../architecture/import-graph.ts';
import { describeDeep, itDeep, itQuick } from '../depth.ts';
import { fallThrough, gq, gqCovered, gqProcess, makeFiles } from './gq.ts';
import { narrowGap, shipped } from './levels.ts';

const SETTINGS: Required<CheckSettings> = {
  terms: {
    accuracy: { name: 'rk4 60 Hz, frame', integrator: 'rk4', rate: 60, tolerance: null, contact: 'frame' },
    maxTime: 20,
    maxWork: 100_000,
    rules: Object.fromEntries(RULE_NAMES.map((name) => [name, RULES[name].default])),
  },
  inFull: true,
  forLock: true,
  proveMinerals: true,
  search: { limits: { budget: null, effort: 2000 }, seed: 1 },
  softlocks: 20_000,
  requireSlack: 1,
};

const noRun = fallThrough({ runs: [] });
const LEVELS: Readonly<Record<string, string | Uint8Array>> = {
  'completable.level.json': fallThrough(),
  'minerals.level.json': readFileSync(shipped('03-let-go')),
  'broken.level.json': fallThrough({ runs: [{ name: 'none', holds: [] }] }),
  'no-run.level.json': noRun,
  'impossible.level.json': fallThrough({ runs: [], range: 120 }),
  'gap.level.json': narrowGap(),
  'a b.level.json': fallThrough({ name: 'a b.level.json', runs: [{ name: '"a b.level.json"', holds: [] }] }),
  'own-name.level.json': fallThrough({ name: ANYWHERE, runs: [{ name: ANYWHERE, holds: [] }] }),
  'syntax.level.json': '{ "version": 1,',
  'unknown.level.json': fallThrough({ colour: ANYWHERE }),
  'raw.level.json': ANYWHERE,
  'not-utf8.level.json': new Uint8Array([0x7b, 0xff, 0x7d]),
  'empty.level.json': '',
};

const { directory, remove } = makeFiles(Object.fromEntries(Object.entries(LEVELS).map(([name, text]) => [`l/${name}`, text])));
afterAll(remove);
const files = Object.keys(LEVELS).map((name) => join(directory, 'l', name));

let made = 0;
const newFolder = (): string => join(directory, `new-${made++}`);

/** Without computing the fingerprint of the code again and again. */
const opened = (folder: string, settings: CheckSettings, code: string | null = 'code') =>
  openLevelCache(folder, settings, () => code);

/** As the command does, without its threads: they run the built code. */
async function check(settings: CheckSettings, folder: string | null, paths: readonly string[] = files): Promise<CheckedLevel[]> {
  const cache = folder === null ? null : opened(folder, settings);
  const known = cache?.recall(paths) ?? new Map<string, CheckedLevel>();
  const levels = paths.map((file) => {
    if (known.has(file)) return known.get(file)!;
    const [{ level, kept }] = checkTogether([{ file }], settings, cache?.key ?? null);
    if (kept !== null) cache?.keep(kept);
    return level;
  });
  await cache?.save();
  return levels;
}

/** As reports print it: JSON does not tell -0 from 0. */
const withoutTime = (levels: readonly CheckedLevel[]): unknown =>
  JSON.parse(JSON.stringify(levels.map((level) => ({ ...level, ms: 0 }))));

/** What has no search, so that checks take a few ms. */
const PLAIN: CheckSettings = {
  ...SETTINGS,
  forLock: false,
  search: null,
  requireSlack: null,
  terms: { ...SETTINGS.terms, maxWork: DEFAULT_MAX_WORK, rules: {} },
};

describe('a report from the cache', () => {
  itQuick.each([
    ['plain', PLAIN],
    ['with everything', { ...SETTINGS, terms: { ...SETTINGS.terms, rules: {} } }],
  ])('is the one without a cache, and the one that was kept to the last digit: %s', async (_, settings) => {
    const folder = newFolder();
    const without = await check(settings, null);
    const first = await check(settings, folder);
    const second = await check(settings, folder);
    expect(withoutTime(first)).toEqual(withoutTime(without));
    const known = opened(folder, settings)!.recall(files);
    // all but the one that can't be told from its path
    expect(files.filter((file) => !known.has(file))).toEqual([join(directory, 'l/own-name.level.json')]);
    for (const [i, level] of second.entries()) {
      if (known.has(level.file)) expect(level).toEqual(first[i]);
      else expect(withoutTime([level])).toEqual(withoutTime([first[i]]));
    }
  });

  it('does not depend on where the file lies', async () => {
    const folder = newFolder();
    await check(PLAIN, folder);
    const moved = join(directory, 'moved "and" $renamed');
    cpSync(join(directory, 'l'), moved, { recursive: true });
    const paths = readdirSync(moved).map((name, i) => {
      const path = join(moved, `$& ${i}.level.json`);
      renameSync(join(moved, name), path);
      return path;
    });
    expect(opened(folder, PLAIN)!.recall(paths).size).toBe(paths.length - 1);
    expect(withoutTime(await check(PLAIN, folder, paths))).toEqual(withoutTime(await check(PLAIN, null, paths)));
  });

  it('is not used for another content, and for the same content again', async () => {
    const folder = newFolder();
    const file = join(directory, 'changing.level.json');
    const seen = new Set<number>();
    const knows = () => opened(folder, PLAIN)!.recall([file]).has(file);
    await fc.assert(
      fc.asyncProperty(fc.integer({ min: 160, max: 170 }), async (x) => {
        writeFileSync(file, fallThrough({ blackHole: { x, y: 0 } }));
        expect(knows()).toBe(seen.has(x));
        seen.add(x);
        const levels = await check(PLAIN, folder, [file]);
        expect(withoutTime(levels)).toEqual(withoutTime(await check(PLAIN, null, [file])));
        expect(knows()).toBe(true);
      }),
      { numRuns: 10 },
    );
    writeFileSync(file, fallThrough({ blackHole: { x: 170.000001, y: 0 } }));
    expect(knows()).toBe(false);
  });

  it('is used only with the same settings: each of them counts', async () => {
    const { key } = opened(newFolder(), SETTINGS)!;
    const keys = new Map([['none', key]]);
    const change = (value: unknown): unknown =>
      typeof value === 'number' ? value + 1 : typeof value === 'boolean' ? !value : value === null ? 1 : `${value}!`;
    const visit = (value: unknown, path: string, whole: (changed: unknown) => unknown): void => {
      if (typeof value !== 'object' || value === null) {
        keys.set(path, opened(newFolder(), whole(change(value)) as CheckSettings)!.key);
        return;
      }
      for (const [name, field] of Object.entries(value))
        visit(field, `${path}/${name}`, (changed) => whole({ ...value, [name]: changed }));
    };
    visit(SETTINGS, '', (changed) => changed);
    for (const name of Object.keys(SETTINGS))
      keys.set(`without ${name}`, opened(newFolder(), { ...SETTINGS, [name]: undefined } as CheckSettings)!.key);
    expect(keys.size).toBeGreaterThan(25);
    expect(new Set(keys.values()).size).toBe(keys.size);
    const turned = Object.fromEntries(Object.entries(SETTINGS).reverse()) as unknown as CheckSettings;
    expect(opened(newFolder(), turned)!.key).toBe(key);
  });

  it('is used only by the same code, and not kept if that has changed meanwhile', async () => {
    const folder = newFolder();
    await check(PLAIN, folder);
    expect(opened(folder, PLAIN)!.recall(files).size).toBeGreaterThan(0);
    expect(opened(folder, PLAIN, 'other code')!.recall(files).size).toBe(0);
    expect(opened(folder, PLAIN, null)).toBeNull();
    const built = newFolder();
    const codes = ['before', 'after'];
    const cache = openLevelCache(built, PLAIN, () => codes.shift()!)!;
    cache.keep(checkTogether([{ file: files[0] }], PLAIN, cache.key)[0].kept!);
    await cache.save();
    expect(existsSync(built)).toBe(false);
  });

  it('of a search that the clock has ended is not kept', async () => {
    const keeps = async (name: string, limits: { budget: number | null; effort: number | null }) => {
      const [folder, file] = [newFolder(), join(directory, name)];
      const settings: CheckSettings = {
        ...PLAIN,
        terms: { ...PLAIN.terms, accuracy: accuracyOf(SETTINGS.terms.accuracy) },
        search: { limits, seed: 0 },
      };
      await check(settings, folder, [file]);
      return opened(folder, settings)!.recall([file]).has(file);
    };
    expect(await keeps('l/gap.level.json', { budget: 0.01, effort: null })).toBe(false);
    expect(await keeps('l/gap.level.json', { budget: 1000, effort: 2000 })).toBe(true);
    // a run that was found shows that the level can be completed, whoever else would have found it
    expect(await keeps('l/no-run.level.json', { budget: 1000, effort: null })).toBe(true);
  });

  it('is not kept of files that could not be read', async () => {
    const folder = newFolder();
    const paths = [join(directory, 'missing.level.json'), directory];
    await check(PLAIN, folder, paths);
    expect(existsSync(folder)).toBe(false);
  });

  it('is the same for a file that is larger than a level may be', async () => {
    const folder = newFolder();
    const file = join(directory, 'large.level.json');
    writeFileSync(file, ' '.repeat(MAX_FILE_SIZE + 1));
    const [first] = await check(PLAIN, folder, [file]);
    expect(opened(folder, PLAIN)!.recall([file]).get(file)).toEqual(first);
  });
});

it('a check that stops at failing levels stops at the same ones, whatever is known already', async () => {
  const bail = (most: number) => ({ most, fails: ({ verdict }: CheckedLevel) => verdict !== 'completable' });
  await fc.assert(
    fc.asyncProperty(
      fc.subarray(files),
      fc.shuffledSubarray(files),
      fc.integer({ min: 1, max: 4 }),
      async (known, asked, most) => {
        const folder = newFolder();
        await check(PLAIN, folder, known);
        const [without, cached] = await Promise.all(
          [null, opened(folder, PLAIN)].map((cache) => checkFiles(asked, PLAIN, 1, () => {}, { bail: bail(most), cache })),
        );
        expect(withoutTime(cached.levels)).toEqual(withoutTime(without.levels));
        expect(cached.unchecked).toEqual(without.unchecked);
      },
    ),
    { numRuns: 15 },
  );
});

it('a damaged cache gives the same reports as none, and is whole again afterwards', async () => {
  const folder = newFolder();
  const without = withoutTime(await check(PLAIN, null));
  await check(PLAIN, folder);
  const shards = readdirSync(folder).filter((name) => name.startsWith('check-'));
  await fc.assert(
    fc.asyncProperty(
      fc.array(fc.tuple(fc.constantFrom(...shards), fc.nat(), fc.integer({ min: 0, max: 255 }), fc.boolean()), {
        minLength: 1,
        maxLength: 30,
      }),
      async (damages) => {
        for (const [name, at, byte, isCut] of damages) {
          const bytes = readFileSync(join(folder, name));
          if (bytes.length > 0) bytes[at % bytes.length] = byte;
          writeFileSync(join(folder, name), isCut ? bytes.subarray(0, at % (bytes.length + 1)) : bytes);
        }
        expect(withoutTime(await check(PLAIN, folder))).toEqual(without);
        expect(opened(folder, PLAIN)!.recall(files).size).toBe(files.length - 1);
      },
    ),
    { numRuns: 20 },
  );
});

describe('the fingerprint of the code that decides', () => {
  const project = makeFiles({
    'schema/index.js': 'schema',
    'engine/index.js': 'engine',
    'engine/deep/a.js': 'a',
    'solver/index.js': 'solver',
    'check/index.js': 'check',
    'cli/check/index.js': 'cli',
  });
  afterAll(project.remove);
  const at = (name: string) => join(project.directory, name);
  const now = () => semantics(project.directory, '.js');

  it('is the same in a copy, whatever else is there', () => {
    const copy = makeFiles({ 'engine/index.d.ts': 'types', 'engine/index.js.map': 'map', 'editor/index.js': 'page' });
    cpSync(project.directory, copy.directory, { recursive: true });
    expect(semantics(copy.directory, '.js')).toBe(now());
    copy.remove();
  });

  it('changes with every module', () => {
    const seen = [now()];
    const steps = [
      ...['schema/index', 'engine/index', 'engine/deep/a', 'solver/index', 'check/index', 'cli/check/index'].map(
        (name) => () => writeFileSync(at(`${name}.js`), 'other'),
      ),
      () => writeFileSync(at('engine/new.js'), ''),
      () => renameSync(at('engine/new.js'), at('engine/newer.js')),
      () => rmSync(at('engine/newer.js')),
      () => mkdirSync(at('engine/empty')),
    ];
    for (const step of steps) {
      step();
      seen.push(now());
    }
    // the last two are back where the first of the additions began
    expect(new Set(seen.slice(0, -2)).size).toBe(seen.length - 2);
    expect(seen.slice(-2)).toEqual([seen[6], seen[6]]);
  });

  itQuick('covers every module and package that a report of a level depends on', () => {
    const root = fileURLToPath(new URL('../../', import.meta.url));
    const sources = readdirSync(root, { recursive: false, encoding: 'utf8' })
      .filter((name) => ['schema', 'engine', 'solver', 'check', 'picture', 'review', 'cli', 'editor'].includes(name))
      .flatMap((room) => readdirSync(join(root, room), { recursive: true, encoding: 'utf8' }).map((name) => `${room}/${name}`))
      .map((path) => path.replaceAll('\\', '/'))
      .filter((path) => /\.tsx?$/.test(path))
      .map((path) => ({ path, text: readFileSync(join(root, path), 'utf8') }));
    const graph = importGraph(sources);
    const reached = new Set(['cli/check/worker.ts']);
    for (const path of reached) for (const next of graph.get(path) ?? []) reached.add(next);
    expect(reached.size).toBeGreaterThan(300);
    expect([...reached].filter((path) => !DECIDING_ROOMS.some((room) => path.startsWith(`${room}/`)))).toEqual([]);
    const packages = sources
      .filter(({ path }) => reached.has(path))
      .flatMap(({ text }) =>
        [...text.matchAll(/^(?:import|export) (?!type )[^;]*? from '(?!\.|node:)([^']+)';/gm)].map(([, name]) => name),
      );
    expect([...new Set(packages)].sort()).toEqual(['commander', 'flatbush', 'picocolors', 'zod']);
    // of these, the ones that decide, and what they need; options, colours and how entries are packed decide nothing
    expect(DECIDING_PACKAGES.map(([name]) => name)).toEqual(['zod', 'flatbush', 'flatqueue']);
  });

  it('without which there is no cache', () => {
    expect(() => semantics(at('nowhere'), '.js')).toThrow('ENOENT');
  });
});

itDeep('a check whose reports are all known loads neither the engine nor zod', async () => {
  const place = makeFiles({ 'levels/a.level.json': fallThrough(), 'levels/b.level.json': fallThrough({ runs: [] }) });
  const loadedOf = async (...options: string[]) =>
    (await gqCovered(['check', '--cache-dir', 'c', ...options], place.directory)).loaded;
  expect(await loadedOf()).toContain('engine/simulate.js');
  const known = await loadedOf();
  for (const name of ['engine/simulate.js', 'schema/level/read-level.js', 'zod']) expect(known).not.toContain(name);
  // a lock is read with zod, and is compared without playing
  expect(await loadedOf('--lock', 'gq.lock.json', '--update-lock')).toContain('engine/simulate.js');
  const locked = await loadedOf('--lock', 'gq.lock.json');
  expect(locked).toContain('zod');
  for (const name of ['engine/simulate.js', 'solver/prove/prove.js', 'check/examine-runs.js']) expect(locked).not.toContain(name);
  place.remove();
});

describe('the folder', () => {
  itQuick('is beside the packages of the nearest project that has some', async () => {
    const project = makeFiles({
      'package.json': '{}',
      'node_modules/x/package.json': '{}',
      'games/one/package.json': '{}',
      'games/one/levels/a.level.json': fallThrough(),
    });
    const cwd = join(project.directory, 'games/one');
    const cache = join(project.directory, 'node_modules/.cache/gq');
    const args = ['check', '--format', 'json'];
    await gq([...args, '--no-cache'], { cwd });
    expect(existsSync(cache)).toBe(false);
    const first = await gq(args, { cwd });
    expect(readdirSync(cache).some((name) => name.startsWith('check-'))).toBe(true);
    // the same bytes, times included
    expect(await gq(args, { cwd })).toEqual(first);
    expect((await gq([...args, '--no-cache'], { cwd })).stdout).not.toBe(first.stdout);
    const elsewhere = await gq([...args, '--cache-dir', 'own/deep'], { cwd });
    expect(elsewhere.stdout).not.toBe(first.stdout);
    expect(await gq([...args, '--cache-dir', 'own/deep'], { cwd })).toEqual(elsewhere);
    // nothing can be written there: no cache, and no error
    const { code, stderr } = await gq([...args, '--cache-dir', 'package.json'], { cwd });
    expect([code, stderr]).toEqual([0, '']);
    const { code: wrong, stderr: why } = await gq([...args, '--cache-dir', ''], { cwd });
    expect([wrong, why]).toEqual([2, expect.stringContaining('expected a folder, found an empty name')]);
    project.remove();
  });

  it('is chosen by an option, else by the configuration', () => {
    expect(chosenCache({}, null)).toBeNull();
    expect(chosenCache({}, false)).toBe(false);
    expect(chosenCache({}, 'there')).toBe('there');
    expect(chosenCache({ cache: true }, false)).toBe(true);
    expect(chosenCache({ cache: true }, 'there')).toBe('there');
    expect(chosenCache({ cache: false }, 'there')).toBe(false);
    expect(chosenCache({ cacheDir: 'here' }, false)).toBe('here');
    expect(chosenCache({ cache: false, cacheDir: 'here' }, true)).toBe(false);
    expect(cacheFolder(false)).toBeNull();
    expect(cacheFolder('there')).toBe('there');
  });
});

describeDeep('processes at once', () => {
  const MANY = 96;
  const crowd = makeFiles(
    Object.fromEntries(
      Array.from({ length: MANY }, (_, i) => [`many/${String(i).padStart(2, '0')}.level.json`, fallThrough({ name: `${i}` })]),
    ),
  );
  afterAll(crowd.remove);
  const cwd = crowd.directory;
  const args = ['check', 'many', '--jobs', '1', '--format', 'json', '--cache-dir', 'c'];
  const withoutTimes = (json: string): string => json.replace(/"ms":[\d.e-]+/g, '"ms":0');

  it.runIf(process.platform !== 'win32')('never give a wrong report, even if they are killed while they write', async () => {
    const { stdout } = await gq(['check', 'many', '--no-cache', '--format', 'json'], { cwd });
    const expected = withoutTimes(stdout);
    for (const delay of [150, 400]) {
      // something to write
      rmSync(join(cwd, 'c'), { recursive: true, force: true });
      const ended = await Promise.all([
        gqProcess(args, { cwd, during: (child) => void setTimeout(() => child.kill('SIGKILL'), delay) }),
        gqProcess(args, { cwd }),
      ]);
      for (const { signal, stdout } of ended) if (signal === null) expect(withoutTimes(stdout)).toBe(expected);
      expect(ended[1].signal).toBeNull();
      expect(withoutTimes((await gq(args, { cwd })).stdout)).toBe(expected);
    }
  });
});
