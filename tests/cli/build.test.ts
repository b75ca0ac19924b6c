import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { runInNewContext } from 'node:vm';
import { afterAll, describe, expect } from 'vitest';
import { buildReportSchema, readLevel } from '../../schema/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { interruptAt } from '../interrupted/step.ts';
import { fallThrough, gq, gqProcess, MAIN, makeFiles } from './gq.ts';
import { narrowGap } from './levels.ts';

const short = { runs: [{ name: 'short', holds: [[0, 1]] }] };
const files = makeFiles({
  'levels/10-last.level.json': fallThrough({ name: 'Last' }),
  'levels/2-first.level.json': fallThrough({ name: 'First', 'x-note': 'mine', $schema: '../s.json' }),
  'levels/world/1.level.json': fallThrough({ name: 'Inside' }),
  'drafts/1-good.level.json': fallThrough({ name: 'Good' }),
  'drafts/2-broken.level.json': fallThrough({ name: 'Broken', ...short }),
  'drafts/3-no-run.level.json': fallThrough({ name: 'No run', runs: [] }),
  'bad/1-good.level.json': fallThrough({ name: 'Good' }),
  'bad/2-invalid.level.json': '{ "version": 1, "name": 3 }',
  'same/a.json': fallThrough(),
  'same/a.level.json': fallThrough(),
  'racing/1.level.json': fallThrough(),
  'slow/1.level.json': fallThrough(),
  'slow/2.level.json': narrowGap(),
  'ruled/gq.config.json': JSON.stringify({
    levels: ['b', 'a'],
    ignore: 'a/draft*',
    rules: { pull: 50 },
    accuracy: 'standard',
    severity: { 'unused-asteroid': 'off' },
  }),
  'ruled/a/1.level.json': fallThrough({ name: 'A' }),
  'ruled/a/draft.level.json': '{',
  'ruled/b/1.level.json': fallThrough({ name: 'B', rules: { pull: 39 } }),
});
const cwd = files.directory;
afterAll(files.remove);
const build = (...args: string[]) => gq(['build', ...args], { cwd });
const read = (name: string): string => readFileSync(join(cwd, name), 'utf8');
const all = (site: string): Record<string, string> =>
  Object.fromEntries(
    readdirSync(join(cwd, site), { recursive: true, withFileTypes: true })
      .filter((entry) => entry.isFile())
      .map(({ parentPath, name }) => [join(parentPath, name).slice(join(cwd, site).length + 1), read(join(site, name))])
      .sort(),
  );

interface PackRead {
  readonly title: string;
  readonly accuracy: string;
  readonly levels: readonly { readonly id: string; readonly level: Record<string, unknown> }[];
}
function packIn(site: string): PackRead {
  const context: Record<string, unknown> = {};
  runInNewContext(read(join(site, 'pack.js')), context);
  // arrays of another context are no arrays of this one
  return JSON.parse(JSON.stringify(context.GRAVITY_QUEST_PACK)) as PackRead;
}
const idsIn = (site: string): string[] => packIn(site).levels.map(({ id }) => id);

describeQuick('gq build', () => {
  it('makes a page of a folder: in the order of play, the same for the same levels, and says what to do next', async () => {
    const made = await build('levels', '--out', 'out/site', '--title', ' My levels ');
    expect(made).toMatchObject({ code: 0, stderr: '' });
    expect(made.stdout).toMatch(
      /^written out\/site\/.*“My levels”: 3 levels, [\d,]+ kB \([\d,]+ kB compressed\)\n\nnext:\n {2}open out\/site\/index\.html/s,
    );
    expect(packIn('out/site')).toMatchObject({ title: 'My levels', accuracy: 'precise' });
    expect(idsIn('out/site')).toEqual(['2-first', '10-last', 'world/1']);
    for (const { level } of packIn('out/site').levels) {
      expect(readLevel(JSON.stringify(level))).toMatchObject({ ok: true });
      expect(Object.keys(level)).not.toContain('x-note');
    }
    expect(readdirSync(join(cwd, 'out'))).toEqual(['site']);
    await build('levels', '--out', 'again', '--title', 'My levels', '--jobs', '1', '--no-cache');
    expect(all('again')).toEqual(all('out/site'));
    const page = read('out/site/index.html');
    expect(page).toContain('<title>My levels</title>');
    expect(page).not.toMatch(/\b(?:src|href)="(?!\.\/|data:)/);
    expect(page).not.toContain('type="module"');
  });

  it('makes a page of one level, with its name', async () => {
    expect(await build('levels/world/1.level.json', '--out', 'alone')).toMatchObject({ code: 0 });
    expect(packIn('alone')).toMatchObject({ title: 'Inside', levels: [{ id: '1', level: { name: 'Inside' } }] });
  });

  it('plays paths in their order, and a file that two of them name where it is named first', async () => {
    expect(await build('levels/10-last.level.json', 'levels', '--out', 'twice')).toMatchObject({ code: 0 });
    expect(idsIn('twice')).toEqual(['10-last', '2-first', 'world/1']);
  });

  it('follows the configuration: paths in their order, ignored files, accuracy, and rules, which become those of each level', async () => {
    const made = await gq(['build', '--out', 'site', '--no-runs', '--format', 'json'], { cwd: join(cwd, 'ruled') });
    expect(made).toMatchObject({ code: 0, stderr: '' });
    const { accuracy, levels } = packIn('ruled/site');
    expect(accuracy).toBe('standard');
    expect(levels.map(({ id, level }) => [id, level.rules, level.runs])).toEqual([
      ['b/1', { pull: 39 }, undefined],
      ['a/1', { pull: 50 }, undefined],
    ]);
    const report = buildReportSchema.parse(JSON.parse(made.stdout));
    expect(report).toMatchObject({ written: true, title: 'Gravity Quest', levels: [{ id: 'b/1' }, { id: 'a/1' }] });
    expect(report.bytes).toBe(report.files.reduce((sum, { bytes }) => sum + bytes, 0));
    expect(report.gzipped).toBeLessThan(report.bytes);
  });

  it('refuses levels that cannot be completed, with what the check says, and writes nothing', async () => {
    const refused = await build('drafts', '--out', 'refused');
    expect(refused).toMatchObject({ code: 1, stdout: '' });
    expect(refused.stderr).toMatch(/^broken drafts\/2-broken\.level\.json \(Broken\): .*\n.*error /);
    expect(refused.stderr).toMatch(/^unproven drafts\/3-no-run\.level\.json \(No run\): .*error no-run/ms);
    expect(refused.stderr).not.toContain('1-good');
    expect(refused.stderr).toMatch(/^nothing was written, because of 2 of 3 levels: .*--force .*\n$/m);
    expect(existsSync(join(cwd, 'refused'))).toBe(false);
    const json = await build('drafts', '--out', 'refused', '--format', 'json');
    const { written, levels, files } = buildReportSchema.parse(JSON.parse(json.stdout));
    expect({ code: json.code, written, files }).toEqual({ code: 1, written: false, files: [] });
    expect(levels.map(({ refused }) => refused)).toEqual([false, true, true]);
  });

  it('builds them with --force, and warns', async () => {
    const forced = await build('drafts', '--out', 'forced', '--force');
    expect(forced.code).toBe(0);
    expect(forced.stderr).toMatch(/warning: built all the same: 2 of 3 levels\n$/);
    expect(idsIn('forced')).toEqual(['1-good', '2-broken', '3-no-run']);
  });

  it('with --solve, puts the run that was found into the page and not into the file', async () => {
    const before = read('drafts/3-no-run.level.json');
    const solved = await build('drafts/3-no-run.level.json', '--out', 'solved', '--solve', '--effort', '20000');
    expect(solved.code).toBe(0);
    expect(packIn('solved').levels[0].level.runs).toEqual([{ name: 'solution', holds: expect.any(Array) }]);
    expect(read('drafts/3-no-run.level.json')).toBe(before);
  });

  it('never builds an invalid level, and names it', async () => {
    for (const force of [[], ['--force']]) {
      const refused = await build('bad', '--out', 'never', ...force);
      expect(refused).toMatchObject({ code: 1, stdout: '' });
      expect(refused.stderr).toMatch(/^invalid bad\/2-invalid\.level\.json: .*\n.*^bad\/2-invalid\.level\.json:1:25: error/ms);
      expect(refused.stderr).toMatch(/nothing was written, because of 1 of 2 levels: .*--force does not build it\n$/);
    }
    expect(existsSync(join(cwd, 'never'))).toBe(false);
  });

  it.each([
    ['nowhere', 'nothing was done'],
    ['levels/2-first.level.json --out ""', 'expected a folder, found an empty name'],
    ['levels --out levels/2-first.level.json', 'is a file'],
    ['levels --out levels/2-first.level.json/site', 'part of its path is a file'],
    ['same/a.json same/a.level.json', 'expected one level "a", found same/a.json as well'],
    ['levels --out x --budget 3', '--solve'],
    ['levels --out x --title ""', 'expected a line of 1 to 200 characters'],
  ])('gq build %s: says what is wrong', async (args, message) => {
    const words = args.split(' ').map((word) => (word === '""' ? '' : word));
    const refused = await build(...words, ...(args.includes('--out') ? [] : ['--out', 'x']));
    expect(refused).toMatchObject({ code: 2, stdout: '' });
    expect(refused.stderr).toContain(message);
    expect(existsSync(join(cwd, 'x'))).toBe(false);
  });
});

describeQuick.runIf(process.platform !== 'win32')('gq build writes nothing', () => {
  const refused = async (env: Readonly<Record<string, string>>, ...args: string[]) => {
    const ended = await gqProcess(['build', ...args, '--out', 'nothing', '--jobs', '1', '--no-cache'], { cwd, env });
    expect(existsSync(join(cwd, 'nothing'))).toBe(false);
    return ended;
  };

  it('of a pipe, which could be read only once', async () => {
    spawnSync('mkfifo', [join(cwd, 'pipe.level.json')]);
    expect(await refused({}, 'pipe.level.json')).toMatchObject({
      code: 2,
      stderr: "error: pipe.level.json: can't be built: it is a named pipe, not a regular file; expected a level file\n",
    });
  });

  it('when a level changes while it is checked', async () => {
    // three files of the game are opened, the level for the pack, and then the level for the check
    const write = { path: join(cwd, 'racing/1.level.json'), text: fallThrough({ name: 'Other' }) };
    expect(await refused(interruptAt({ of: 'openSync', number: 5, write }), 'racing')).toMatchObject({
      code: 2,
      stderr: expect.stringContaining('racing/1.level.json: the file has changed during the check, so nothing was written'),
    });
  });

  it('when a signal ends the check', async () => {
    const env = interruptAt({ of: 'postMessage', after: 'online', number: 1, signals: ['SIGINT'] });
    expect(await refused(env, 'slow', '--solve', '--budget', '20', '--force')).toMatchObject({
      code: 130,
      stdout: '',
      stderr: 'nothing was written: the check was interrupted\n',
    });
  });
});

describe('the folder of gq build', () => {
  const LEVEL = 'levels/world/1.level.json';

  it('stays as it is when something else is in it, unless --overwrite writes beside that', async () => {
    mkdirSync(join(cwd, 'mine'));
    writeFileSync(join(cwd, 'mine/notes.txt'), 'mine');
    const refused = await build(LEVEL, '--out', 'mine');
    expect(refused).toMatchObject({ code: 2, stdout: '' });
    expect(refused.stderr).toMatch(
      /gq build has not made this folder, and it is not empty \(notes\.txt\): expected .*--overwrite/,
    );
    expect(readdirSync(join(cwd, 'mine'))).toEqual(['notes.txt']);
    // the folder is looked at first: a check may take long
    expect((await build('drafts', '--out', 'mine')).stderr).toBe(refused.stderr);
    expect((await build(LEVEL, '--out', 'levels/..')).stderr).toMatch(/not empty \(\S+, \S+, \S+ and \d+ more\)/);
    // --force is about levels
    expect((await build(LEVEL, '--out', 'mine', '--force')).code).toBe(2);
    expect((await build(LEVEL, '--out', 'mine', '--overwrite')).code).toBe(0);
    expect(read('mine/notes.txt')).toBe('mine');
    // from now on it is known
    expect((await build(LEVEL, '--out', 'mine')).stdout).toMatch(/^unchanged: \d+ other files\n/);
  });

  it('is filled when it is empty', async () => {
    mkdirSync(join(cwd, 'empty'));
    expect((await build(LEVEL, '--out', 'empty')).code).toBe(0);
    expect(idsIn('empty')).toEqual(['1']);
  });

  it('gets only what has changed, loses only what an earlier build has written, and keeps what others have', async () => {
    await build('levels', '--out', 'kept');
    const marker = JSON.parse(read('kept/.gq-build.json'));
    const hash = marker.files['pack.js'];
    // an earlier version of the game had more files, of which one has changed since
    for (const name of ['gone/a.js', 'old/a.js', 'old/b.js', 'mine.js']) {
      mkdirSync(join(cwd, 'kept', name, '..'), { recursive: true });
      writeFileSync(join(cwd, 'kept', name), name === 'old/b.js' ? 'changed' : read('kept/pack.js'));
    }
    writeFileSync(join(cwd, 'outside.js'), read('kept/pack.js'));
    for (const name of ['gone/a.js', 'old/a.js', 'old/b.js']) marker.files[name] = hash;
    writeFileSync(join(cwd, 'kept/.gq-build.json'), JSON.stringify(marker));
    const again = await build(LEVEL, '--out', 'kept');
    expect(again).toMatchObject({ code: 0 });
    expect(again.stdout).toContain('overwritten kept/pack.js\n');
    expect(again.stdout).toContain('removed kept/old/a.js\n');
    expect(existsSync(join(cwd, 'kept/old/a.js'))).toBe(false);
    expect(existsSync(join(cwd, 'kept/gone'))).toBe(false);
    expect(read('kept/old/b.js')).toBe('changed');
    expect(existsSync(join(cwd, 'kept/mine.js'))).toBe(true);
  });

  it('is not trusted when its list of files leads out of it', async () => {
    await build('levels', '--out', 'forged');
    const marker = JSON.parse(read('forged/.gq-build.json'));
    writeFileSync(join(cwd, 'outside.js'), read('forged/pack.js'));
    for (const name of ['../outside.js', 'a/../../outside.js', join(cwd, 'outside.js'), '..\\outside.js']) {
      const files = { ...marker.files, [name]: marker.files['pack.js'] };
      writeFileSync(join(cwd, 'forged/.gq-build.json'), JSON.stringify({ ...marker, files }));
      expect((await build(LEVEL, '--out', 'forged')).code).toBe(2);
      expect(existsSync(join(cwd, 'outside.js'))).toBe(true);
    }
  });

  it('is not left through a link in it, whatever its list of files says', async () => {
    await build('levels', '--out', 'leads');
    const hash = JSON.parse(read('leads/.gq-build.json')).files['pack.js'];
    const content = read('leads/pack.js');
    mkdirSync(join(cwd, 'away'));
    writeFileSync(join(cwd, 'away/pack.js'), content);
    // as stale files of an earlier version
    symlinkSync('../away', join(cwd, 'leads/old'));
    const marker = JSON.parse(read('leads/.gq-build.json'));
    marker.files['old/pack.js'] = hash;
    writeFileSync(join(cwd, 'leads/.gq-build.json'), JSON.stringify(marker));
    expect((await build(LEVEL, '--out', 'leads')).code).toBe(0);
    expect(read('away/pack.js')).toBe(content);
    // as files of this one
    await build('levels', '--out', 'leads');
    for (const [name, target] of [
      ['pack.js', '../away/pack.js'],
      ['game.js', '../away/new.js'],
    ]) {
      const kept = read(join('leads', name));
      rmSync(join(cwd, 'leads', name));
      symlinkSync(target, join(cwd, 'leads', name));
      const refused = await build(LEVEL, '--out', 'leads');
      expect(refused).toMatchObject({ code: 2, stdout: '' });
      expect(refused.stderr).toContain(`\n  leads/${name}\n`);
      rmSync(join(cwd, 'leads', name));
      writeFileSync(join(cwd, 'leads', name), kept);
    }
    expect(all('away')).toEqual({ 'pack.js': content });
  });

  it('keeps a file of the page that somebody has changed, but for the ends of its lines', async () => {
    await build(LEVEL, '--out', 'edited');
    writeFileSync(join(cwd, 'edited/pack.js'), read('edited/pack.js').replaceAll('\n', '\r\n'));
    expect((await build('levels', '--out', 'edited')).code).toBe(0);
    const mine = `${read('edited/index.html')}<!-- mine -->`;
    writeFileSync(join(cwd, 'edited/index.html'), mine);
    const refused = await build(LEVEL, '--out', 'edited');
    expect(refused).toMatchObject({ code: 2, stdout: '' });
    expect(refused.stderr).toMatch(/nothing was written.*\n {2}edited\/index\.html\n.*--overwrite/);
    expect(read('edited/index.html')).toBe(mine);
    expect(idsIn('edited')).toHaveLength(3);
    expect((await build(LEVEL, '--out', 'edited', '--overwrite')).code).toBe(0);
    expect(read('edited/index.html')).not.toBe(mine);
  });

  itDeep.runIf(process.platform !== 'win32')(
    'is known after a build that was killed, and complete after the same build again',
    async () => {
      /** kill -9 before a file gets its place */
      const killed = async (number: number, ...args: string[]) => {
        const env = interruptAt({ of: 'renameSync', number, signals: ['SIGKILL'] });
        expect((await gqProcess(['build', ...args, '--no-cache'], { cwd, env })).signal).toBe('SIGKILL');
      };
      await build('levels', '--out', 'all');
      mkdirSync(join(cwd, 'killed'));
      await killed(3, LEVEL, '--out', 'killed');
      expect(readdirSync(join(cwd, 'killed'))).not.toContain('pack.js');
      expect((await build(LEVEL, '--out', 'killed')).code).toBe(0);
      // the page has another title, and the file that lists its files is written last
      await killed(3, 'levels', '--out', 'killed');
      expect(read('killed/pack.js')).toBe(read('all/pack.js'));
      expect(read('killed/.gq-build.json')).not.toBe(read('all/.gq-build.json'));
      expect((await build('levels', '--out', 'killed')).code).toBe(0);
      expect(all('killed')).toMatchObject(all('all'));
    },
  );

  it('may be reached through a link', async () => {
    mkdirSync(join(cwd, 'real'));
    symlinkSync('real', join(cwd, 'linked'));
    expect((await build(LEVEL, '--out', 'linked')).code).toBe(0);
    expect(idsIn('real')).toEqual(['1']);
  });

  itDeep('is not there when the disk is full, nor are folders above it; an earlier page stays whole', async () => {
    // the kernel's limit for file sizes, KiB: it refuses more, like a full disk
    const onFullDisk = (...args: string[]) =>
      spawnSync('bash', ['-c', `trap '' XFSZ; ulimit -f 100; exec "$0" "$@"`, process.execPath, MAIN, 'build', ...args], {
        cwd,
        encoding: 'utf8',
      });
    const { status, stderr } = onFullDisk(LEVEL, '--out', 'full/a/b');
    expect(stderr).toMatch(/^error: --out full\/a\/b: can't be written: .*nothing was written\n$/);
    expect(status).toBe(2);
    expect(existsSync(join(cwd, 'full'))).toBe(false);

    await build(LEVEL, '--out', 'whole');
    const before = all('whole');
    rmSync(join(cwd, 'whole/game.js'));
    const again = onFullDisk('levels', '--out', 'whole');
    expect(again.status).toBe(2);
    expect(all('whole')).toEqual(Object.fromEntries(Object.entries(before).filter(([name]) => name !== 'game.js')));
  });
});
