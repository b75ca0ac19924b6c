import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, readFileSync, realpathSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, beforeEach, describe, expect } from 'vitest';
import { formatLevel, type LevelFile, readLevel } from '../../schema/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { GIT_ENVIRONMENT } from './git-environment.ts';
import { gq, MAIN, makeFiles } from './gq.ts';

// She falls from rest through an asteroid at y 100 into the black hole below while the gun is held.
const BASE: LevelFile = {
  version: 1,
  name: 'fall',
  astronaut: { x: 0, y: 0 },
  blackHole: { x: 0, y: 200 },
  asteroids: [{ id: 'aa', x: 0, y: 100, radius: 16 }],
  novae: [
    { id: 'n1', x: 400, y: 0, radius: 16 },
    { id: 'n2', x: -400, y: 0, radius: 16 },
  ],
  runs: [{ name: 'solution', holds: [[0, 600]] }],
};
type Changes = Partial<LevelFile>;
const level = (changes: Changes = {}): string => formatLevel({ ...BASE, ...changes });
const novae = (x1: number, x2: number): Changes => ({
  novae: [
    { id: 'n1', x: x1, y: 0, radius: 16 },
    { id: 'n2', x: x2, y: 0, radius: 16 },
  ],
});

let folder: ReturnType<typeof makeFiles>;
const at = (name: string) => join(folder.directory, name);
const read = (name: string) => readFileSync(at(name), 'utf8');
const levelIn = (name: string): LevelFile => {
  const reading = readLevel(readFileSync(at(name)));
  if (!reading.ok) throw new Error(reading.problems[0].message);
  return reading.document.file;
};
afterEach(() => folder.remove());

describeQuick('gq merge-driver', () => {
  async function merge(base: string | Uint8Array, ours: string | Uint8Array, theirs: string | Uint8Array, ...more: string[]) {
    folder = makeFiles({ base, ours, theirs });
    const ended = await gq(['merge-driver', ...more, 'base', 'ours', 'theirs', 'levels/x.level.json'], { cwd: folder.directory });
    expect(ended.stdout).toBe('');
    return ended;
  }

  it('merges what is apart, in the canonical layout, and says nothing', async () => {
    const crlf = Buffer.from(`\ufeff${level({ name: 'theirs' }).replaceAll('\n', '\r\n')}`);
    expect(await merge(level(), level(novae(500, -400)).trimEnd(), crlf)).toMatchObject({ code: 0, stderr: '' });
    expect(read('ours')).toBe(level({ ...novae(500, -400), name: 'theirs' }));
  });

  it('keeps the bytes of the only side that changed', async () => {
    const odd = JSON.stringify(JSON.parse(level({ name: 'odd' })));
    expect(await merge(level(), level(), odd)).toMatchObject({ code: 0, stderr: '' });
    expect(read('ours')).toBe(odd);
    folder.remove();
    expect(await merge(level(), odd, level())).toMatchObject({ code: 0, stderr: '' });
    expect(read('ours')).toBe(odd);
  });

  it('leaves conflicts in a valid file, which check refuses and other commands warn of', async () => {
    const ended = await merge(level(), level(novae(500, -400)), level(novae(600, -700)));
    expect(ended.code).toBe(1);
    expect(ended.stderr).toBe(
      'levels/x.level.json: 1 conflict: nova n1, place; our values stand in the file, and "conflicts" has both\n' +
        'levels/x.level.json: to decide: gq edit levels/x.level.json, then: git add levels/x.level.json\n',
    );
    expect(levelIn('ours')).toMatchObject({
      ...novae(500, -700),
      conflicts: [{ key: 'novae/n1/place', ours: { x: 500, y: 0 }, theirs: { x: 600, y: 0 } }],
    });
    const check = await gq(['check', 'ours', '--format', 'json'], { cwd: folder.directory });
    expect(check.code).toBe(1);
    expect(JSON.parse(check.stdout).levels[0]).toMatchObject({
      verdict: 'invalid',
      problems: [{ code: 'merge-conflict', severity: 'error', line: 4, column: 5, pointer: '/conflicts/0' }],
    });
    const simulate = await gq(['simulate', 'ours'], { cwd: folder.directory });
    expect(simulate).toMatchObject({ code: 0 });
    expect(simulate.stderr).toBe(
      'warning: ours has a conflict of a merge: gq used our values; gq check lists them, gq edit decides them\n',
    );
    const before = read('ours');
    expect((await gq(['fmt', 'ours'], { cwd: folder.directory })).code).toBe(0);
    expect(read('ours')).toBe(before);
  });

  it('finds objects without ids that one side moved and the other changed', async () => {
    const bare = (changes: Changes) => level(changes).replaceAll(/"id": "\w+", /g, '');
    const big = { novae: BASE.novae?.map((nova) => ({ ...nova, radius: 20 })) };
    expect((await merge(bare({}), bare(novae(500, -600)), bare(big))).code).toBe(0);
    expect(levelIn('ours').novae).toMatchObject([
      { x: 500, radius: 20 },
      { x: -600, radius: 20 },
    ]);
  });

  it('takes both where both added the file', async () => {
    expect((await merge('', level(), level({ ...novae(400, -400), minerals: [{ id: 'mm', x: 1, y: 2 }] }))).code).toBe(0);
    expect(levelIn('ours').minerals).toHaveLength(1);
  });

  it('plays the runs again: a level that no run completes any more is looked at', async () => {
    // ours turns her way to the right, and theirs puts a nova there
    const ours = level({ asteroids: [{ id: 'aa', x: 100, y: 0, radius: 16 }], blackHole: { x: 170, y: 0 } });
    const theirs = level(novae(140, -400));
    const ended = await merge(level(), ours, theirs);
    expect(ended.code).toBe(1);
    expect(ended.stderr).toMatch(
      /^levels\/x\.level\.json: merged, and the run "solution" now dies at tick \d+, at nova 1 \(before: completed at tick \d+ on our side and \d+ on theirs\)\nlevels\/x\.level\.json: fix it \(/,
    );
    expect(levelIn('ours').conflicts).toBeUndefined();
    folder.remove();
    const warned = await merge(level(), ours, theirs, '--on-broken-run', 'warn');
    expect(warned.code).toBe(0);
    expect(warned.stderr).toMatch(/now dies at tick/);
  });

  it('merges files that are no levels as text, and says why', async () => {
    const ended = await merge('a\nb\n', 'a\nours\n', 'a\ntheirs\n', '--marker-size', '9');
    expect(ended.code).toBe(1);
    expect(ended.stderr).toMatch(/our version is not a valid level: 1:1 .*; merged as text: its conflicts are marked\n$/);
    expect(read('ours')).toBe('a\n<<<<<<<<< ours\nours\n=========\ntheirs\n>>>>>>>>> theirs\n');
    folder.remove();
    const clean = await merge('a\nb\nc\nd\ne\n', 'A\nb\nc\nd\ne\n', 'a\nb\nc\nd\nE\n');
    expect(clean).toMatchObject({ code: 0 });
    expect(read('ours')).toBe('A\nb\nc\nd\nE\n');
    folder.remove();
    const binary = Buffer.from([0, 1, 2]);
    const odd = await merge(Buffer.from([0, 9]), binary, Buffer.from([0, 3]));
    expect(odd.code).toBe(1);
    expect(odd.stderr).toContain('not merged: our version stands');
    expect(readFileSync(at('ours'))).toEqual(binary);
  });

  it('fails with the code that stops git when a file is missing', async () => {
    folder = makeFiles({ base: level(), ours: level() });
    const ended = await gq(['merge-driver', 'base', 'ours', 'none', 'x.level.json'], { cwd: folder.directory });
    expect(ended).toMatchObject({ code: 129 });
    expect(ended.stderr).toMatch(/^x\.level\.json: none: can't be read/);
  });
});

describe('git, set up by gq git-setup', () => {
  const environment = { ...GIT_ENVIRONMENT, GIT_EDITOR: 'true' };
  const FILE = "levels/it's a.level.json";
  const run = (...args: string[]) => {
    const { status, stdout, stderr } = spawnSync('git', args, { cwd: folder.directory, env: environment, encoding: 'utf8' });
    return { status, out: stdout.trim(), said: stdout + stderr };
  };
  const git = (...args: string[]) => {
    const { status, out, said } = run(...args);
    if (status !== 0) throw new Error(`git ${args.join(' ')}: ${said}`);
    return out;
  };
  const commit = (content: string, message = 'change', file = FILE) => {
    writeFileSync(at(file), content);
    git('add', '-A');
    git('commit', '-qm', message);
  };
  /** Commits one version on a branch `other`, and one on `main`. */
  const fork = (ours: string, theirs: string) => {
    git('checkout', '-qb', 'other');
    commit(theirs);
    git('checkout', '-q', 'main');
    commit(ours);
  };
  const setUp = (...more: string[]) => gq(['git-setup', ...more], { cwd: folder.directory });

  let original: ReturnType<typeof makeFiles>;
  beforeAll(async () => {
    original = makeFiles({ [FILE]: level(), '.gitattributes': '*.png binary' });
    folder = original;
    git('init', '-qb', 'main', '--template=');
    expect((await setUp()).code).toBe(0);
    git('add', '-A');
    git('commit', '-qm', 'base');
  });
  afterAll(() => original.remove());
  beforeEach(() => {
    folder = makeFiles({});
    cpSync(original.directory, folder.directory, { recursive: true });
  });

  const moved = level(novae(500, -400));
  const named = level({ name: 'theirs' });
  const both = level({ ...novae(500, -400), name: 'theirs' });

  it('is set up once, checked, and undone without a trace', async () => {
    expect((await setUp()).stdout).toBe('git merges and compares levels with gq\n');
    expect(await setUp('--check')).toMatchObject({ code: 0 });
    expect(read('.gitattributes').split('\n')).toEqual([
      '*.png binary',
      '# gq git-setup: levels are merged and compared by gq',
      '*.level.json merge=gq-level diff=gq-level text eol=lf',
    ]);
    expect((await setUp('--on-broken-run', 'warn')).stdout).toMatch(/^changed merge\.gq-level\.driver/);
    expect(git('config', 'merge.gq-level.driver')).toContain('--on-broken-run=warn');
    expect(await setUp('--check')).toMatchObject({ code: 0 });
    writeFileSync(at('.gitattributes'), `${read('.gitattributes')}\n*.json -merge\n`);
    expect(await setUp('--check')).toMatchObject({ code: 1 });
    expect((await setUp('--undo')).code).toBe(0);
    expect(read('.gitattributes')).toBe('*.png binary\n*.json -merge\n');
    expect(read('.git/config')).not.toContain('gq');
    expect((await setUp('--undo')).stdout).toBe('nothing to undo\n');
    const check = await setUp('--check');
    expect(check.code).toBe(1);
    expect(check.stdout).toContain('merge.gq-level.driver is not set in this clone');
  });

  itDeep('merges, rebases, picks and pops what is apart', () => {
    fork(moved, named);
    git('merge', '-q', '--no-edit', 'other');
    expect(read(FILE)).toBe(both);
    git('reset', '-q', '--hard', 'HEAD^');
    git('cherry-pick', 'other');
    expect(read(FILE)).toBe(both);
    git('reset', '-q', '--hard', 'HEAD^');
    git('checkout', '-q', 'other');
    git('rebase', '-q', 'main');
    expect(read(FILE)).toBe(both);
    git('reset', '-q', '--hard', 'main');
    writeFileSync(at(FILE), level({ ...novae(500, -400), description: 'kept' }));
    git('stash', '-q');
    commit(both);
    git('stash', 'pop', '-q');
    expect(levelIn(FILE)).toMatchObject({ name: 'theirs', description: 'kept' });
  });

  itDeep('merges into a file that one side renamed, and where both added it', () => {
    git('checkout', '-qb', 'other');
    git('mv', FILE, 'levels/b.level.json');
    commit(named, 'renamed', 'levels/b.level.json');
    git('checkout', '-q', 'main');
    commit(moved);
    git('merge', '-q', '--no-edit', 'other');
    expect(read('levels/b.level.json')).toBe(both);

    git('checkout', '-qb', 'third');
    commit(level(), 'added', 'levels/new.level.json');
    git('checkout', '-q', 'main');
    commit(level({ minerals: [{ id: 'mm', x: 300, y: 300 }] }), 'added', 'levels/new.level.json');
    git('merge', '-q', '--no-edit', 'third');
    expect(levelIn('levels/new.level.json').minerals).toHaveLength(1);
  });

  it('stops at a conflict with a valid file, and at a deleted one as ever', () => {
    fork(moved, level(novae(600, -400)));
    const { status, said } = run('merge', '--no-edit', 'other');
    expect(status).toBe(1);
    expect(said).toContain(`${FILE}: 1 conflict: nova n1, place`);
    expect(git('ls-files', '-u').split('\n')).toHaveLength(3);
    expect(levelIn(FILE)).toMatchObject({ ...novae(500, -400), conflicts: [{ key: 'novae/n1/place' }] });
    git('merge', '--abort');
    git('rm', '-q', FILE);
    git('commit', '-qm', 'deleted');
    expect(run('merge', '--no-edit', 'other').said).toContain('modify/delete');
    expect(existsSync(at(FILE))).toBe(true);
  });

  itDeep('merges across a criss-cross, whose base is itself a merge with conflicts', () => {
    fork(moved, level(novae(600, -400)));
    const [ours, theirs] = [git('rev-parse', 'main'), git('rev-parse', 'other')];
    run('merge', '--no-edit', theirs);
    commit(level({ ...novae(500, -400), name: 'first' }));
    git('checkout', '-q', 'other');
    run('merge', '--no-edit', ours);
    commit(level(novae(600, -900)));
    git('checkout', '-q', 'main');
    expect(run('merge', '--no-edit', 'other').status).toBe(1);
    expect(levelIn(FILE)).toMatchObject({
      name: 'first',
      ...novae(500, -900),
      conflicts: [{ key: 'novae/n1/place', ours: { x: 500 }, theirs: { x: 600 } }],
    });
  });

  it('starts gq from where it is installed, whatever the names of folders', () => {
    const driver = git('config', 'merge.gq-level.driver');
    expect(driver).toContain(`'${realpathSync(MAIN)}'`);
    expect(driver).toContain('; gq merge-driver --marker-size=%L %O %A %B %P; ');
  });
});

describeQuick('gq git-setup', () => {
  it('says what is missing where git has no working tree', async () => {
    folder = makeFiles({});
    const setUp = () => gq(['git-setup'], { cwd: folder.directory });
    const outside = await setUp();
    expect(outside).toMatchObject({ code: 2 });
    expect(outside.stderr).toContain('expected a git repository, found none');
    spawnSync('git', ['init', '-q', '--bare'], { cwd: folder.directory });
    const bare = await setUp();
    expect(bare).toMatchObject({ code: 2 });
    expect(bare.stderr).toContain('found a bare repository');
  });
});
