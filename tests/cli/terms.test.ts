import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Command } from 'commander';
import { afterAll, describe, expect } from 'vitest';
import { COMMANDS } from '../../cli/commands/index.ts';
import { compile, DEFAULT_TERMS } from '../../engine/index.ts';
import { createPlayer, encodePlay, playOf } from '../../game/index.ts';
import { type LevelFile, readLevel, resolveLevel } from '../../schema/index.ts';
import { measureDifficulty } from '../../solver/index.ts';
import { describeDeep, describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { type Ended, gq, makeFiles } from './gq.ts';

// She swings around an asteroid past a nova, whose place decides between accuracies.
const swing = (nova: { readonly x: number; readonly y: number }, changes: object = {}) => ({
  version: 1,
  name: 'Swing',
  astronaut: { x: 0, y: 0, vx: 60 },
  blackHole: { x: 300, y: -35, radius: 60 },
  range: 400,
  asteroids: [{ id: 'a1', x: 150, y: -60, radius: 16 }],
  novae: [{ id: 'n1', ...nova, radius: 8 }],
  runs: [{ name: 's', holds: [[0, 150]] }],
  ...changes,
});
const FAR = { x: 120, y: 300 };
/** Completes at every accuracy, in 2.8 s. */
const EASY = swing(FAR);
/** Completes in continuous time, and collides in `arcade`. */
const BROKEN_IN_ARCADE = swing({ x: 120, y: 13.22 }, { rules: { pull: 37 } });
/** Drifts into the black hole after 85 s. */
const SLOW: LevelFile = {
  version: 1,
  name: 'Slow',
  astronaut: { x: 0, y: 0, vx: 2 },
  blackHole: { x: 220, y: 0, radius: 40 },
  asteroids: [{ x: 100, y: -60, radius: 16 }],
  runs: [
    { name: 's', holds: [[6000, 6010]] },
    { name: 'early', holds: [[1, 2]] },
  ],
};

/** Terms that are not the usual ones, as a configuration and as options say them; no options: only a configuration says it. */
interface Unusual {
  readonly config: { readonly accuracy?: string; readonly maxTime?: number; readonly maxWork?: number; readonly rules?: object };
  readonly options: readonly string[] | null;
}

const USUAL = { accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {} };
const UNUSUAL = {
  arcade: { config: { accuracy: 'arcade' }, options: ['--accuracy', 'arcade'] },
  time: { config: { maxTime: 1 }, options: ['--max-time', '1'] },
  work: { config: { maxWork: 20 }, options: ['--max-work', '20'] },
  rules: { config: { rules: { speedLimit: 50 } }, options: null },
} as const satisfies Readonly<Record<string, Unusual>>;
type Kind = keyof typeof UNUSUAL;

const FILES = {
  'levels/easy.level.json': JSON.stringify(EASY),
  'levels/level.level.json': JSON.stringify(BROKEN_IN_ARCADE),
  'old.level.json': JSON.stringify(swing(FAR, { rules: { pull: 37 } })),
  'arcade.gqr': encodePlay(playOfOwnRun(EASY)),
};

/** The play of a level's first run. */
function playOfOwnRun(file: object) {
  const reading = readLevel(JSON.stringify(file));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  const player = createPlayer(reading.level, { replay: reading.level.runs[0].holds });
  while (player.ending === null) player.advance(100);
  return playOf(player);
}

const remove: (() => void)[] = [];
afterAll(() => {
  for (const one of remove) one();
});

/** A folder with the files, and a configuration. */
function folderWith(config: object, files: Readonly<Record<string, string | Uint8Array>> = FILES): string {
  const made = makeFiles({ ...files, 'gq.config.json': JSON.stringify(config), '.git/HEAD': '' });
  remove.push(made.remove);
  return made.directory;
}

/** Runs gq in a folder. */
const run = (folder: string, args: readonly string[]): Promise<Ended> => gq(args, { cwd: folder });
const LEVEL = 'levels/level.level.json';

/** What a command says: the part that depends on terms, and the terms that it names; null where its report is not JSON. */
interface Said {
  readonly answer: unknown;
  readonly terms: unknown;
}

/** A probe of a command. */
interface Probe {
  /** Asks in a folder; options say the terms where the command has them. */
  readonly ask: (folder: string, options: readonly string[]) => Promise<Said>;
  /** The kinds of terms that change its answer. */
  readonly kinds: readonly Kind[];
  /** Whether the terms can only come from the configuration: by the kind. */
  readonly onlyConfigured?: readonly Kind[];
}

const ALL_KINDS = Object.keys(UNUSUAL) as Kind[];

/** The JSON that a command prints; `exit CODE` where it prints none. */
async function report<T>(folder: string, args: readonly string[], pick: (json: T) => unknown): Promise<Said> {
  const { code, stdout } = await run(folder, args);
  if (stdout === '') return { answer: `exit ${code}`, terms: null };
  const json = JSON.parse(stdout);
  return { answer: pick(json), terms: json.terms ?? json.levels[0].terms ?? json.levels[0].after.terms };
}

const text = async (folder: string, args: readonly string[]): Promise<Said> => {
  const { code, stdout } = await run(folder, args);
  return { answer: `exit ${code} ${stdout}`, terms: null };
};

const inLevels =
  <T>(pick: (level: T) => unknown) =>
  ({ levels: [first] }: { readonly levels: readonly T[] }) =>
    pick(first);

/** Splits a set, does its shards in a folder with another configuration, and puts them together. */
async function planned(folder: string, options: readonly string[]): Promise<Said> {
  const plan = await run(folder, ['plan', LEVEL, '--shards', '1', '-o', 'plan.json', '--force', ...options]);
  expect(plan).toMatchObject({ code: 0 });
  const config = readFileSync(join(folder, 'gq.config.json'));
  // shards and the merge have the terms of the plan, whatever is configured where they run
  writeFileSync(join(folder, 'gq.config.json'), JSON.stringify({ accuracy: 'fast', maxTime: 30 }));
  rmSync(join(folder, 'results'), { recursive: true, force: true });
  const shard = await run(folder, ['check', '--plan', 'plan.json', '--shard', '0', '--out', 'results', '-j', '1']);
  expect(shard.code, shard.stderr).toBeLessThan(2);
  const merged = await report<{ levels: { verdict: string }[] }>(
    folder,
    ['merge', 'results', '--plan', 'plan.json', '--format', 'json'],
    inLevels(({ verdict }) => verdict),
  );
  writeFileSync(join(folder, 'gq.config.json'), config);
  return merged;
}

/** What `gq merge-driver` says of a clean merge. @param theirs what they have changed */
async function mergeIn(folder: string): Promise<Said> {
  const deep = join(folder, 'packs/one');
  mkdirSync(deep, { recursive: true });
  const write = (name: string, level: object) => writeFileSync(join(folder, name), JSON.stringify(level));
  write('base', swing(FAR));
  write('ours', swing({ x: 120, y: 13.22 }));
  write('theirs', swing(FAR, { rules: { pull: 37 } }));
  const { code, stderr } = await run(folder, ['merge-driver', 'base', 'ours', 'theirs', 'packs/one/x.level.json']);
  return { answer: `exit ${code} ${stderr}`, terms: null };
}

/** Each command that answers something about a level: how to ask it, and which terms change its answer. */
const PROBES: Readonly<Record<string, Probe>> = {
  check: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ levels: { verdict: string; run: { hash: string } | null }[] }>(
        folder,
        ['check', LEVEL, '--format', 'json', '--no-cache', ...options],
        inLevels(({ verdict, run: shown }) => [verdict, shown?.hash]),
      ),
  },
  simulate: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ outcome: string; hash: string }>(
        folder,
        ['simulate', LEVEL, '--format', 'json', ...options],
        ({ outcome, hash }) => [outcome, hash],
      ),
  },
  solve: {
    kinds: ['arcade', 'time', 'rules'],
    ask: (folder, options) =>
      report<{ found: boolean; hash: string | null }>(
        folder,
        ['solve', LEVEL, '--effort', '20000', '--objective', 'first', '-j', '1', '--format', 'json', ...options],
        ({ found, hash }) => [found, hash],
      ),
  },
  fix: {
    kinds: ['arcade', 'time', 'rules'],
    ask: (folder, options) =>
      report<{ verdict: string }>(
        folder,
        ['fix', LEVEL, '--effort', '1', '--format', 'json', ...options],
        ({ verdict }) => verdict,
      ),
  },
  difficulty: {
    kinds: ['arcade', 'time', 'rules'],
    ask: (folder, options) =>
      report<{ levels: { measured: object | null }[] }>(
        folder,
        ['difficulty', LEVEL, 'levels/easy.level.json', '--run', 's', '--effort', '1', '-j', '1', '--format', 'json', ...options],
        ({ levels }) => levels.map(({ measured }) => measured !== null),
      ),
  },
  tune: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ levels: { run: string | null; intervals: object[] }[] }>(
        folder,
        ['tune', 'old.level.json', LEVEL, '--set', 'boxHeight=0.99x', '-j', '1', '--format', 'json', ...options],
        ({ levels }) => levels.map(({ run: name, intervals }) => [name, intervals]),
      ),
  },
  inspect: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ modes: object[]; work: object }>(folder, ['inspect', LEVEL, '--format', 'json', ...options], ({ modes, work }) => [
        modes,
        work,
      ]),
  },
  render: { kinds: ALL_KINDS, ask: (folder, options) => text(folder, ['render', LEVEL, '-o', '-', ...options]) },
  diff: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ levels: { after: { verdict: string; run: object | null; terms: object } }[] }>(
        folder,
        ['diff', 'old.level.json', LEVEL, '--format', 'json', ...options],
        ({ levels: [{ after }] }) => [after.verdict, after.run],
      ),
  },
  build: {
    kinds: ['arcade', 'time', 'work', 'rules'],
    ask: (folder, options) =>
      report<{ levels: { verdict: string; problems: object[] }[] }>(
        folder,
        ['build', LEVEL, '--out', 'site', '--force', '--overwrite', '--no-cache', '-j', '1', '--format', 'json', ...options],
        inLevels(({ verdict, problems }) => [verdict, problems]),
      ),
  },
  plan: { kinds: ALL_KINDS, ask: planned },
  merge: { kinds: ALL_KINDS, ask: planned },
  difftool: {
    kinds: ALL_KINDS,
    onlyConfigured: ALL_KINDS,
    ask: (folder) => text(folder, ['difftool', LEVEL, 'old.level.json', '0', '0', LEVEL, '1', '1']),
  },
  'merge-driver': { kinds: ['arcade'], onlyConfigured: ALL_KINDS, ask: mergeIn },
  verify: {
    kinds: ['work', 'rules'],
    ask: (folder, options) =>
      text(folder, ['verify', 'arcade.gqr', '--levels', 'levels/easy.level.json', '-j', '1', '--format', 'json', ...options]),
  },
  // a level takes minutes: tests/solver/generate.test.ts looks at what is kept under other terms
  generate: {
    kinds: ALL_KINDS,
    ask: (folder, options) =>
      report<{ terms: object }>(
        folder,
        ['generate', '--out', 'made', '--effort', '1', '-j', '1', '--format', 'json', ...options],
        ({ terms }) => terms,
      ),
  },
  // it measures every accuracy, for seconds
  accuracy: {
    kinds: ['time'],
    onlyConfigured: ['time', 'rules'],
    ask: (folder, options) =>
      report<{ reference: { outcome: string } }>(
        folder,
        ['accuracy', LEVEL, '--format', 'json', ...options],
        ({ reference: { outcome } }) => outcome,
      ),
  },
};

/** The commands that say nothing that terms could change, and why. */
const WITHOUT_TERMS: Readonly<Record<string, string>> = {
  submit: 'starts shards, which have the terms of their plan',
  'git-setup': 'writes what git is to call',
  import: 'turns files into level files',
  export: 'turns level files into others',
  init: 'writes a project',
  fmt: 'lays files out',
  schema: 'prints the shape of a file',
  explain: 'explains a code',
  completion: 'prints a script for a shell',
  edit: 'serves the page, whose terms tests/server looks at',
};

describeQuick('every command', () => {
  it('either answers under the asked terms, and is tested here, or answers nothing about a level', () => {
    const known = [...Object.keys(PROBES), ...Object.keys(WITHOUT_TERMS)];
    expect(COMMANDS.map(({ name }) => name).sort()).toEqual(known.sort());
  });

  it('has options that hide nothing that a configuration says', async () => {
    const ofConfiguration = ['accuracy', 'maxTime', 'maxWork', 'requireSlack', 'maxWarnings', 'lock', 'cache', 'reporter'];
    for (const { name, load } of COMMANDS) {
      const command = new Command(name);
      (await load()).declare(command, () => {});
      for (const option of command.options) {
        // commander makes `true` the default of what --no-... turns off
        if (option.negate || !ofConfiguration.includes(option.attributeName())) continue;
        expect(option.defaultValue, `gq ${name} ${option.long}`).toBeUndefined();
      }
    }
  });
});

const before = new Map<string, Promise<Said>>();
/** What a command says under the usual terms. */
const usually = (name: string): Promise<Said> => {
  const known = before.get(name) ?? PROBES[name].ask(folderWith({}), []);
  before.set(name, known);
  return known;
};

const answersUnderOtherTerms = (name: string, test: Pick<typeof it, 'each'>): void => {
  const { ask, kinds, onlyConfigured = ['rules'] } = PROBES[name];

  test.each(kinds)('answers under other terms: %s', async (kind) => {
    const usual = await usually(name);
    const { config, options }: Unusual = UNUSUAL[kind];
    const configured = await ask(folderWith(config), []);
    expect(configured.answer).not.toEqual(usual.answer);
    // what is generated has no rules of its own
    const own = name === 'generate' ? {} : { pull: 37 };
    if (usual.terms !== null) expect(usual.terms).toEqual({ ...USUAL, rules: own });
    if (configured.terms !== null) expect(configured.terms).toEqual({ ...USUAL, ...config, rules: { ...own, ...config.rules } });
    if (options === null || onlyConfigured.includes(kind)) return;
    // options say the same, and win over a configuration
    const asked = await ask(folderWith(OTHERWISE[kind]), options);
    expect(asked.answer).toEqual(configured.answer);
  });
};

// gq accuracy measures every accuracy, for seconds
describeDeep('gq accuracy', () => answersUnderOtherTerms('accuracy', itDeep));
describeQuick.each(Object.keys(PROBES).filter((name) => name !== 'accuracy'))('gq %s', (name) =>
  answersUnderOtherTerms(name, it),
);

/** Configurations that an option has to win over. */
const OTHERWISE: Readonly<Record<Kind, object>> = {
  arcade: { accuracy: 'standard' },
  time: { maxTime: 59 },
  work: { maxWork: 399_999 },
  rules: {},
};

describe('a run that lasts longer than 60 s', () => {
  const folder = () => folderWith({ maxTime: 120 }, { 'slow.level.json': JSON.stringify(SLOW) });

  itDeep('is one for slack, certified ticks, softlocks, difficulty and fixes, too', async () => {
    const at = folder();
    const slow = resolveLevel(SLOW);
    // as gq difficulty does, with fewer samples
    const few = { samples: 20, games: 20, effort: 0, asteroidEffort: 0, onePressStride: 600, playerEffort: 0 };
    const hard = measureDifficulty(compile(slow, { ...DEFAULT_TERMS, maxTime: 120 }), slow.runs[1].holds, few);
    expect(hard?.robustness.certifiedTicks).toBeGreaterThan(0);
    expect(await run(at, ['check', 'slow.level.json', '--require-slack', '1'])).toMatchObject({ code: 0 });
    expect(await run(at, ['check', 'slow.level.json', '--require-slack', '1', '--max-time', '60'])).toMatchObject({ code: 1 });
    const softlocks = await run(at, ['check', 'slow.level.json', '--softlocks', '50000', '--format', 'json']);
    expect(JSON.parse(softlocks.stdout).levels[0]).toMatchObject({
      verdict: 'completable',
      softlocks: { states: { proved: 0, notFound: 0 } },
    });
    const fixed = await run(at, ['fix', 'slow.level.json', '--effort', '1000', '--format', 'json']);
    expect(JSON.parse(fixed.stdout)).toMatchObject({ verdict: 'completable', completedBy: 's' });
    const other = await run(at, ['check', 'slow.level.json', '--no-config']);
    expect(other).toMatchObject({ code: 1 });
  });

  it('is found by a search where --max-time allows it, and only there', async () => {
    const at = folderWith({}, { 'new.level.json': JSON.stringify({ ...EASY, runs: [] }) });
    const solved = async (...more: string[]) => {
      const asked = ['check', 'new.level.json', '--solve', '--effort', '200000', '--format', 'json', '-j', '1', ...more];
      const { levels } = JSON.parse((await run(at, asked)).stdout);
      return levels[0];
    };
    expect(await solved('--max-time', '90')).toMatchObject({ verdict: 'completable', terms: { maxTime: 90 } });
    expect((await solved('--max-time', '1')).verdict).not.toBe('completable');
  });
});

describeQuick('the merge driver', () => {
  const merge = async (config: object, ours: object, theirs: object) => {
    const at = folderWith(
      {},
      {
        base: JSON.stringify(EASY),
        ours: JSON.stringify(ours),
        theirs: JSON.stringify(theirs),
        'packs/gq.config.json': JSON.stringify(config),
      },
    );
    const { code, stderr } = await run(at, ['merge-driver', 'base', 'ours', 'theirs', 'packs/x.level.json']);
    writeFileSync(join(at, 'packs/x.level.json'), readFileSync(join(at, 'ours')));
    const checked = await run(at, ['check', 'packs/x.level.json', '--config', 'packs/gq.config.json']);
    return { code, stderr, checked: checked.code };
  };
  const pull = (value: number) => swing(FAR, { rules: { pull: value } });

  it('says of a merged level what gq check says under the configuration of its folder', async () => {
    for (const [config, code] of [
      [{}, 0],
      [{ accuracy: 'arcade' }, 1],
      [{ accuracy: 'fast' }, 0],
    ] as const)
      expect(await merge(config, swing({ x: 120, y: 13.22 }), pull(37)), JSON.stringify(config)).toMatchObject({
        code,
        checked: code,
      });
    for (const [config, code] of [
      [{}, 1],
      [{ accuracy: 'arcade' }, 0],
    ] as const)
      expect(await merge(config, swing({ x: 120, y: -41.98 }), pull(41)), JSON.stringify(config)).toMatchObject({
        code,
        checked: code,
      });
  });
});

describeQuick('the warnings', () => {
  it('allow for how far recoil carries asteroids in the longest run', async () => {
    const level = {
      version: 1,
      name: 'Far',
      recoil: true,
      range: 100,
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 200, y: 0, radius: 20 },
      asteroids: [{ x: 60, y: 0, radius: 16 }],
    };
    const at = folderWith({}, { 'far.level.json': JSON.stringify(level) });
    const warned = async (...more: string[]) => {
      const { stdout } = await run(at, ['inspect', 'far.level.json', '--format', 'json', ...more]);
      return JSON.parse(stdout).problems.map(({ code }: { code: string }) => code);
    };
    expect(await warned('--max-time', '5')).toContain('black-hole-out-of-reach');
    expect(await warned('--max-time', '600')).not.toContain('black-hole-out-of-reach');
  });
});

describeQuick('a lock', () => {
  it('that was agreed on under other limits differs, in words', async () => {
    const at = folderWith({}, { 'easy.level.json': JSON.stringify(EASY) });
    const locked = (...more: string[]) => run(at, ['check', 'easy.level.json', '--lock', 'gq.lock.json', ...more]);
    expect(await locked('--update-lock')).toMatchObject({ code: 0 });
    expect(readFileSync(join(at, 'gq.lock.json'), 'utf8')).not.toContain('maxTime');
    expect(await locked()).toMatchObject({ code: 0 });
    const { code, stdout } = await locked('--max-time', '120', '--max-work', '500000');
    expect(code).toBe(1);
    expect(stdout).toContain('result-changed: time limit 120 s, before the usual limit; work limit 500000 pieces of motion');
    expect(await locked('--max-time', '120', '--update-lock')).toMatchObject({ code: 0 });
    expect(readFileSync(join(at, 'gq.lock.json'), 'utf8')).toContain('"maxTime": 120');
    expect(await locked('--max-time', '120')).toMatchObject({ code: 0 });
  });
});

describeQuick('a plan', () => {
  it('has the terms, and a shard takes no others', async () => {
    const at = folderWith({ accuracy: 'arcade', maxTime: 120 });
    expect(await run(at, ['plan', LEVEL, '--shards', '1', '-o', 'plan.json'])).toMatchObject({ code: 0 });
    const { settings } = JSON.parse(readFileSync(join(at, 'plan.json'), 'utf8'));
    expect(settings.terms).toMatchObject({ accuracy: { name: 'arcade' }, maxTime: 120 });
    const shard = await run(at, ['check', '--plan', 'plan.json', '--shard', '0', '--out', 'results', '--max-time', '60']);
    expect(shard).toMatchObject({ code: 2 });
    expect(shard.stderr).toContain('--max-time comes from the plan');
  });
});

describeQuick('a report for people', () => {
  it('says terms that are not the usual ones', async () => {
    const at = folderWith({ accuracy: 'arcade', maxTime: 120 });
    expect((await run(at, ['check', 'levels/easy.level.json'])).stdout).toContain(
      '1 level, at arcade, at most 120 s: 1 completable',
    );
    expect((await run(at, ['check', 'levels/easy.level.json', '--no-config'])).stdout).toContain('1 level: 1 completable');
  });
});
