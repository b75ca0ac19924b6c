import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { afterAll, beforeAll, describe, expect } from 'vitest';
import { applyDiff, type Change } from '../../review/index.ts';
import { type DiffReport, diffReportSchema, formatLevel, type LevelFile, withIds } from '../../schema/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { fallThrough, gq, MAIN, makeFiles } from './gq.ts';
import { shipped } from './levels.ts';

// with real git, in repositories of their own

const QUIET = { GIT_CONFIG_GLOBAL: '/dev/null', GIT_CONFIG_SYSTEM: '/dev/null', GIT_CONFIG_NOSYSTEM: '1' };
const IDENTITY = ['-c', 'user.name=A', '-c', 'user.email=a@example.org', '-c', 'commit.gpgsign=false'];

const run = (cwd: string, ...args: string[]): string =>
  execFileSync('git', [...IDENTITY, ...args], { cwd, encoding: 'utf8', env: { ...process.env, ...QUIET }, stdio: 'pipe' });

const THROUGH = JSON.parse(fallThrough()) as LevelFile;
const level = (changes: Partial<LevelFile> = {}): string => formatLevel(withIds({ ...THROUGH, ...changes }));
const firewalk = JSON.parse(readFileSync(shipped('16-firewalk'), 'utf8')) as LevelFile;

let root: string;
let remove: () => void;
const path = (name: string): string => join(root, name);
const write = (name: string, text: string): void => {
  mkdirSync(dirname(path(name)), { recursive: true });
  writeFileSync(path(name), text);
};
const diff = (...args: string[]) => gq(['diff', ...args], { cwd: root });
const reportWithSlack = async (...args: string[]): Promise<DiffReport> => {
  const { stdout, stderr } = await diff('--format', 'json', '--accuracy', 'arcade', ...args);
  if (stdout === '') throw new Error(stderr);
  return diffReportSchema.parse(JSON.parse(stdout));
};
/** Slack takes most of the time; two reports have it. */
const report = (...args: string[]): Promise<DiffReport> => reportWithSlack('--no-slack', ...args);
const brief = ({ levels }: DiffReport) => levels.map(({ file, status, words }) => [file, status, ...words]);

beforeAll(() => {
  ({ directory: root, remove } = makeFiles({}));
  run(root, 'init', '-q', '-b', 'main');
  write('levels/a.level.json', level());
  write('levels/b.level.json', formatLevel(firewalk));
  write('levels/c d.level.json', level({ name: 'C' }));
  write('notes.json', '{}');
  run(root, 'add', '-A');
  run(root, 'commit', '-qm', 'one');
  run(root, 'tag', 'one');
});
afterAll(() => remove());

describeQuick('gq diff in a repository', () => {
  it('says that nothing changed, and ends with 0', async () => {
    expect(await diff('--exit-code')).toMatchObject({
      code: 0,
      stdout: 'HEAD -> the working tree: no level changed\n',
      stderr: '',
    });
  });

  it('compares the working tree with HEAD: changed, laid out anew, new, gone and broken files', async () => {
    const [asteroid, ...others] = firewalk.asteroids ?? [];
    write(
      'levels/b.level.json',
      formatLevel({ ...firewalk, asteroids: [{ ...asteroid, x: asteroid.x + 12, y: asteroid.y - 3 }, ...others] }),
    );
    write('levels/a.level.json', JSON.stringify(JSON.parse(level())));
    write('levels/new.level.json', readFileSync(shipped('18-grand-tour'), 'utf8'));
    write('levels/bad.level.json', '{ "version": 1,');
    write('notes.json', '{ "x": 1 }');
    rmSync(path('levels/c d.level.json'));
    const found = await reportWithSlack();
    expect(brief(found)).toEqual([
      ['levels/a.level.json', 'layout'],
      ['levels/b.level.json', 'changed', 'hot asteroid 1 moved 12 px right and 3 px up'],
      ['levels/bad.level.json', 'added'],
      ['levels/c d.level.json', 'removed'],
      ['levels/new.level.json', 'added'],
    ]);
    expect(found.levels[2].after).toMatchObject({ verdict: 'invalid', problems: [{ line: 1 }] });
    const shown = await diff('--no-slack', '--exit-code');
    expect(shown.code).toBe(1);
    expect(shown.stdout).toContain('only the layout changed');
    expect(shown.stdout).toContain('levels/bad.level.json:1:');
    expect(shown.stdout).toContain('1 changed, 3 added, 1 removed, 1 only laid out anew'.replace('3 added', '2 added'));
    expect((await diff()).code).toBe(0);
  });

  it('has changes in JSON that turn one version into the other', async () => {
    const { levels } = await report();
    const { changes } = levels[1];
    const after = readFileSync(path('levels/b.level.json'), 'utf8');
    expect(formatLevel(applyDiff(firewalk, changes as unknown as Change[]))).toBe(after);
  });

  it('is limited by paths, also from a folder inside, where paths are relative to it', async () => {
    expect(brief(await report('HEAD', 'levels/new.level.json')).map(([file]) => file)).toEqual(['levels/new.level.json']);
    expect(brief(await report('--', 'levels/c d.level.json')).map(([file]) => file)).toEqual(['levels/c d.level.json']);
    expect(brief(await report('HEAD', '--', 'levels/n*.json')).map(([file]) => file)).toEqual(['levels/new.level.json']);
    const inside = await gq(['diff', 'b.level.json', '--no-slack'], { cwd: path('levels') });
    expect(inside.stdout).toContain('~ b.level.json');
    expect(inside.stdout).not.toContain('new.level.json');
    expect((await gq(['diff', '--no-slack'], { cwd: path('levels') })).stdout).toContain('+ new.level.json');
  });

  it('compares revisions and ranges, and the index', async () => {
    run(root, 'checkout', '-qb', 'feature');
    run(root, 'add', '-A');
    expect(brief(await report('--staged'))).toHaveLength(5);
    run(root, 'commit', '-qm', 'two');
    run(root, 'checkout', '-q', 'main');
    write('levels/a.level.json', level({ name: 'Main' }));
    run(root, 'commit', '-qam', 'three');
    expect(brief(await report())).toEqual([]);
    const files = async (...args: string[]) => brief(await report(...args)).map(([file]) => file.replace('levels/', ''));
    expect(await files('one')).toEqual(['a.level.json']);
    expect(await files('one', 'main')).toEqual(['a.level.json']);
    expect(await files('one..main')).toEqual(['a.level.json']);
    expect(await files('main', 'feature', '--', 'levels/new.level.json')).toEqual(['new.level.json']);
    const apart = ['a.level.json', 'b.level.json', 'bad.level.json', 'c d.level.json', 'new.level.json'];
    expect(await files('main..feature')).toEqual(apart);
    // since both parted, main's own change is not part of it
    expect(brief(await report('main...feature'))[0]).toEqual(['levels/a.level.json', 'layout']);
    expect(await files('feature...')).toEqual(['a.level.json']);
  });

  it('follows renames, also of files that were laid out anew', async () => {
    renameSync(path('levels/b.level.json'), path('levels/z.level.json'));
    const text = JSON.stringify(JSON.parse(formatLevel({ ...firewalk, name: 'Renamed' })));
    write('levels/z.level.json', text);
    const { levels } = await report();
    expect(levels).toMatchObject([
      { status: 'changed', before: { file: 'levels/b.level.json' }, after: { file: 'levels/z.level.json' } },
    ]);
    expect(levels[0].words).toEqual(['renamed "Firewalk" -> "Renamed"']);
    run(root, 'checkout', '-q', '.');
    rmSync(path('levels/z.level.json'));
    run(root, 'mv', 'levels/b.level.json', 'levels/y.level.json');
    expect(brief(await report())).toEqual([['levels/y.level.json', 'renamed']]);
    run(root, 'reset', '-q', '--hard');
  });

  it('says what a change leads to', async () => {
    write('levels/a.level.json', level({ name: 'Main', novae: [{ x: 60, y: 0, radius: 16 }] }));
    const { stdout } = await diff('--accuracy', 'arcade');
    expect(stdout).toContain('nova 1 added at (60, 0)');
    expect(stdout).toContain('=> completable -> ');
    expect(stdout).toContain('1 level no longer completable');
    write('levels/a.level.json', level({ name: 'Main', blackHole: { x: 150, y: 0 } }));
    const [{ effects }] = (await reportWithSlack()).levels;
    expect(effects.some((line) => /^\d+(\.\d+)? s faster$/.test(line))).toBe(true);
    run(root, 'reset', '-q', '--hard');
  });

  it('says that a change of the configuration changes every level', async () => {
    write('gq.config.json', '{ "rules": { "pull": 80 } }');
    const { rules, levels, same } = await report();
    expect(rules).toEqual([{ rule: 'pull', before: null, after: 80 }]);
    expect(levels.every(({ status, effects }) => status === 'rules' && effects.length > 0)).toBe(true);
    expect(levels.length + same).toBe(3);
    const { stdout } = await diff('--accuracy', 'arcade');
    expect(stdout).toContain('gq.config.json  rules changed, which changes how every level plays: pull unset -> 80');
    run(root, 'add', 'gq.config.json');
    run(root, 'commit', '-qm', 'rules');
    expect((await report('HEAD~', 'HEAD')).rules).toHaveLength(1);
    write('gq.config.json', '{ "rules": ');
    expect(await diff()).toMatchObject({ code: 2, stderr: expect.stringContaining('gq.config.json:1:') });
    run(root, 'commit', '-qam', 'broken');
    const broken = await diff('HEAD~', 'HEAD');
    expect(broken.stderr).toContain('warning: gq.config.json in HEAD is not valid, and is left out: line 1:');
    run(root, 'reset', '-q', '--hard', 'HEAD~2');
  });

  it.each([
    [['nowhere'], 'nowhere: expected a revision or a file, found neither'],
    [['note.json'], '(did you mean notes.json?)'],
    [['HEAD', '--', 'nothing', 'levels'], 'a path matches no level file on either side\n  nothing\n'],
    [['HEAD', '--', 'notes'], 'matches no level file'],
    [['one', 'main', 'feature'], 'expected at most two revisions, found 3'],
    [['--staged', 'one', 'main'], '--staged and two revisions cannot be combined'],
    [['--staged', 'one..main'], '--staged and one..main cannot be combined'],
    [['nowhere', '--'], 'nowhere: expected a commit, branch or tag, found no such revision'],
    [['--format', 'nonsense'], 'Allowed choices are text, json'],
    [['levels', 'notes.json'], 'levels is a folder: expected two files or two folders'],
  ])('refuses %j', async (args, message) => {
    const ended = await diff(...args);
    expect(ended).toMatchObject({ code: 2, stdout: '' });
    expect(ended.stderr).toContain(message);
  });

  it('asks which is meant where a word is a revision and a file', async () => {
    write('one', level());
    const { code, stderr } = await diff('one');
    expect(code).toBe(2);
    expect(stderr).toContain('write gq diff one -- for the revision, gq diff -- one for the file');
    expect((await report('one', '--')).before).toBe('one');
    expect(brief(await report('--', 'one'))).toEqual([['one', 'added']]);
    rmSync(path('one'));
  });

  it('shows both sides of a file with conflicts', async () => {
    run(root, 'checkout', '-qb', 'other');
    write('levels/a.level.json', level({ name: 'Other' }));
    run(root, 'commit', '-qam', 'other');
    run(root, 'checkout', '-q', 'main');
    write('levels/a.level.json', level({ name: 'Mine' }));
    run(root, 'commit', '-qam', 'mine');
    expect(() => run(root, 'merge', '-q', 'other')).toThrow();
    const { levels } = await report();
    expect(levels).toMatchObject([
      { file: 'levels/a.level.json', before: { verdict: 'completable' }, after: { verdict: 'invalid' } },
    ]);
    run(root, 'merge', '--abort');
  });

  it('says so if history is missing', async () => {
    const clone = `${root}-clone`;
    run(root, 'clone', '-q', '--depth', '1', `file://${root}`, clone);
    const { code, stderr } = await gq(['diff', 'HEAD~1'], { cwd: clone });
    rmSync(clone, { recursive: true, force: true });
    expect(code).toBe(2);
    expect(stderr).toContain('this clone is shallow: git fetch --unshallow');
  });
});

describe('gq inside git', () => {
  const GQ = `"${process.execPath}" "${MAIN}"`.replaceAll('\\', '/');
  const shown = (...args: string[]): string =>
    execFileSync('git', args, {
      cwd: root,
      encoding: 'utf8',
      env: { ...process.env, ...QUIET, DISPLAY: '', WAYLAND_DISPLAY: '', NO_COLOR: '1' },
    });
  beforeAll(() => {
    write('.git/info/attributes', '*.level.json diff=gq-level\n');
    write('levels/a.level.json', level({ name: 'Inside', blackHole: { x: 171, y: 0 } }));
  });

  it('is a textconv: git diff shows a line for each object', async () => {
    const text = shown('-c', `diff.gq-level.textconv=${GQ} diff --textconv`, 'diff', '--', 'levels/a.level.json');
    expect(text).toContain('-black hole at (170, 0)\n+black hole at (171, 0)\n');
    write('levels/a.level.json', '{ "version": 1');
    // what git would show of it: a textconv that fails would end git diff
    const invalid = await gq(['diff', '--textconv', 'levels/a.level.json'], { cwd: root });
    expect(invalid).toMatchObject({ code: 0, stdout: expect.stringMatching(/^not a valid level: 1:/) });
    write('levels/a.level.json', level({ name: 'Inside', blackHole: { x: 171, y: 0 } }));
  });

  itDeep('is an external diff: git diff prints what changed in words', () => {
    const text = shown('-c', `diff.gq-level.command=${GQ} difftool`, 'diff', '--ext-diff', '--', 'levels/a.level.json');
    expect(text).toContain('~ levels/a.level.json');
    expect(text).toContain('black hole moved 1 px right');
  });

  itDeep('is a difftool: it writes a page, and prints its path where there is no display', () => {
    const tool = `${GQ} difftool "$LOCAL" "$REMOTE" "$MERGED"`;
    const text = shown('-c', `difftool.gq.cmd=${tool}`, 'difftool', '--no-prompt', '--tool=gq', '--', 'levels/a.level.json');
    expect(text).toMatch(/gq-diff-\w+[\\/]a\.level\.json\.html\n$/);
    const page = text.trim();
    expect(readFileSync(page, 'utf8')).toContain('black hole moved 1 px right');
    rmSync(dirname(page), { recursive: true });
  });

  it('refuses other arguments', async () => {
    expect(await gq(['difftool', 'a', 'b', 'c', 'd'], { cwd: root })).toMatchObject({
      code: 2,
      stderr: expect.stringContaining('expected LOCAL REMOTE [PATH]'),
    });
    expect(await gq(['difftool', 'levels/a.level.json'], { cwd: root })).toMatchObject({
      code: 0,
      stdout: '* unmerged levels/a.level.json\n',
    });
    expect(await diff('--textconv', 'levels/a.level.json', 'HEAD')).toMatchObject({ code: 2 });
    expect(await diff('--textconv', 'nowhere.json')).toMatchObject({ code: 2, stderr: expect.stringContaining('no such file') });
  });
});

describeQuick('gq diff of files and folders, without git', () => {
  const files = makeFiles({
    'old/a.level.json': level(),
    'old/gone.level.json': level({ name: 'Gone', astronaut: { x: 1, y: 1 } }),
    'old/same.level.json': level({ name: 'Same' }),
    'new/a.level.json': level({ blackHole: { x: 171, y: 0 } }),
    'new/same.level.json': level({ name: 'Same' }),
    'new/sub/moved.level.json': level({ name: 'Moved', astronaut: { x: 1, y: 1 } }),
  });
  afterAll(() => files.remove());
  const compare = async (...args: string[]) => gq(['diff', '--no-slack', ...args], { cwd: files.directory });

  it('compares two files', async () => {
    const { code, stdout } = await compare('old/a.level.json', 'new/a.level.json');
    expect(code).toBe(0);
    expect(stdout).toContain('black hole moved 1 px right');
    expect(stdout).toContain('old/a.level.json -> new/a.level.json: 1 changed');
    expect((await compare('old/a.level.json', 'old/a.level.json', '--exit-code')).code).toBe(0);
    expect((await compare('old/a.level.json', '/dev/null')).stdout).toContain('1 removed');
  });

  it('says of the bytes of a file what a check says of them', async () => {
    const text = level();
    const contents: Readonly<Record<string, string | Buffer>> = {
      plain: text,
      'other-layout': JSON.stringify(JSON.parse(text)),
      'line-ends': text.replaceAll('\n', '\r\n'),
      mark: `\ufeff${text}`,
      utf16: Buffer.from(`\ufeff${text}`, 'utf16le'),
      pointer: 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n',
      merge: text.replace('{\n', '{\n<<<<<<< HEAD\n=======\n>>>>>>> b\n'),
      twice: text.replace('"version": 1', '"version": 1, "version": 1'),
      empty: '',
    };
    const folder = join(files.directory, 'bytes');
    mkdirSync(folder, { recursive: true });
    for (const [name, content] of Object.entries(contents)) writeFileSync(join(folder, `${name}.level.json`), content);
    const judged = (one: { verdict: string; problems: readonly { code: string; line: number | null }[] } | null) => [
      one?.verdict,
      ...(one?.problems.map(({ code, line }) => [code, line]) ?? []),
    ];
    const options = ['--accuracy', 'arcade', '--format', 'json'];
    const check = await gq(['check', 'bytes', ...options], { cwd: files.directory });
    const said = new Map<string, unknown>(
      JSON.parse(check.stdout).levels.map((one: { file: string }) => [one.file, judged(one as never)]),
    );
    expect(said.size).toBe(Object.keys(contents).length);
    for (const name of Object.keys(contents)) {
      const path = `bytes/${name}.level.json`;
      const pairs = [
        [path, 'bytes/plain.level.json'],
        ['bytes/plain.level.json', path],
      ];
      for (const pair of pairs) {
        if (name === 'plain') continue;
        const { stdout } = await compare(...pair, ...options);
        const [found] = diffReportSchema.parse(JSON.parse(stdout)).levels;
        expect([judged(found.before), judged(found.after)], name).toEqual(pair.map((one) => said.get(one)));
      }
    }
    const { stdout } = await compare('bytes/mark.level.json', 'bytes/plain.level.json');
    expect(stdout).toContain('before: bytes/mark.level.json:1:1: the file begins with a byte order mark');
    expect(stdout).toContain('invalid -> completable');
    const lines = await compare('--textconv', 'bytes/mark.level.json');
    expect(lines.stdout).toMatch(/^not a valid level: 1:1: the file begins with a byte order mark.*\n[^{]*black hole at/s);
  });

  it('calls a level with conflicts of a merge invalid, as a check does', async () => {
    const conflicts = [
      { what: 'the black hole', key: 'blackHole/place', base: null, ours: { x: 170, y: 0 }, theirs: { x: 9, y: 0 } },
    ];
    writeFileSync(join(files.directory, 'undecided.level.json'), formatLevel({ ...THROUGH, conflicts }));
    const { stdout } = await compare('old/a.level.json', 'undecided.level.json');
    expect(stdout).toContain('completable -> invalid');
  });

  it('compares two folders by the paths in them', async () => {
    const { stdout } = await compare('old', 'new');
    expect(stdout).toContain('old -> new: 2 changed');
    expect(stdout).toContain('old/gone.level.json -> new/sub/moved.level.json');
    expect(stdout).toContain('renamed "Gone" -> "Moved"');
    expect(stdout).not.toContain('same.level.json');
  });

  it('says what to give outside of a repository', async () => {
    for (const args of [[], ['HEAD'], ['old/a.level.json']]) {
      const { code, stderr } = await compare(...args);
      expect(code).toBe(2);
      expect(stderr).toContain('expected two files or two folders');
    }
  });
});
