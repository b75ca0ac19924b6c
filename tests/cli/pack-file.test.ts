import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { runInNewContext } from 'node:vm';
import { afterAll, describe, expect, it } from 'vitest';
import { keepPack } from '../../cli/generate/index.ts';
import { buildReportSchema, checkReportSchema, difficultyReportSchema } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';

const pack = (...levels: readonly unknown[]): string => JSON.stringify({ version: 1, name: 'My game', levels });
const CLEAN = { 'x-seen': 'for the tests' };

const files = makeFiles({
  'ordered/1-a.level.json': fallThrough({ name: 'A' }),
  'ordered/2-b.level.json': fallThrough({ name: 'B' }),
  'ordered/10-c.level.json': fallThrough({ name: 'C' }),
  'ordered/world/1.level.json': fallThrough({ name: 'Inside' }),
  'ordered/pack.json': pack({ chapter: 'One' }, 'world/1', '10-c', { chapter: 'Two' }, '1-a'),
  'wrong/1-a.level.json': fallThrough(),
  'wrong/2-b.level.json': fallThrough(),
  'wrong/pack.json': pack('1-a', '2-bb', '1-a', '2-b'),
  'invalid/1-a.level.json': fallThrough(),
  'invalid/2-b.level.json': fallThrough(),
  'invalid/pack.json': '{ "version": 1, "name": "a", "levels": ["2-b", } }',
  'set/gq.config.json': JSON.stringify({
    severity: { 'pack-unlisted-level': 'error', 'pack-missing-level': 'off' },
    ignore: 'draft*',
  }),
  'set/levels/1.level.json': fallThrough(),
  'set/levels/2.level.json': fallThrough(),
  'set/levels/draft.level.json': '{',
  'set/levels/pack.json': pack('1', 'gone'),
  'empty/1.level.json': fallThrough(),
  'empty/pack.json': pack(),
  'plain/2-b.level.json': fallThrough(),
  'plain/10-a.level.json': fallThrough(),
});
const cwd = files.directory;
afterAll(files.remove);
const run = (...args: string[]) => gq(args, { cwd });

async function checked(folder: string, ...more: string[]) {
  const { stdout, code } = await run('check', folder, '--format', 'json', '--no-cache', ...more);
  return { code, report: checkReportSchema.parse(JSON.parse(stdout)) };
}

describe('pack.json', () => {
  it('puts levels in order: the same in check, difficulty and build, which leaves out what is not listed', async () => {
    const { report, code } = await checked('ordered');
    const listed = ['ordered/world/1.level.json', 'ordered/10-c.level.json', 'ordered/1-a.level.json'];
    expect(code).toBe(0);
    expect(report.levels.map(({ file }) => file)).toEqual([...listed, 'ordered/2-b.level.json']);
    expect(report.packs?.map(({ file, name, problems }) => [file, name, problems.map((one) => one.code)])).toEqual([
      ['ordered/pack.json', 'My game', ['pack-unlisted-level']],
    ]);

    const built = await run('build', 'ordered', '--out', 'site', '--format', 'json', '--no-cache');
    const build = buildReportSchema.parse(JSON.parse(built.stdout));
    expect(build.levels.map(({ file }) => file)).toEqual(listed);
    expect(build.leftOut).toEqual(['2-b']);
    expect(build.title).toBe('My game');
    const context: Record<string, { levels: { id: string; chapter?: string }[] }> = {};
    runInNewContext(readFileSync(join(cwd, 'site', 'pack.js'), 'utf8'), context);
    expect(context.GRAVITY_QUEST_PACK.levels.map(({ id, chapter }) => [id, chapter])).toEqual([
      ['world/1', 'One'],
      ['10-c', 'One'],
      ['1-a', 'Two'],
    ]);

    const measured = await run('difficulty', 'ordered', '--format', 'json', '--effort', '1000');
    const difficulty = difficultyReportSchema.parse(JSON.parse(measured.stdout));
    expect(difficulty.packs?.map(({ levels }) => levels)).toEqual([listed]);
  });

  it('changes nothing where there is none: check sorts by path, build by the order of play', async () => {
    const { report } = await checked('plain');
    expect(report.levels.map(({ file }) => file)).toEqual(['plain/10-a.level.json', 'plain/2-b.level.json']);
    expect(report).not.toHaveProperty('packs');
    const built = await run('build', 'plain', '--out', 'plain-site', '--format', 'json', '--no-cache');
    const build = buildReportSchema.parse(JSON.parse(built.stdout));
    expect(build.levels.map(({ file }) => file)).toEqual(['plain/2-b.level.json', 'plain/10-a.level.json']);
    expect(build).not.toHaveProperty('leftOut');
  });

  it('with errors fails the check, and nothing is built', async () => {
    const { report, code } = await checked('wrong');
    expect(code).toBe(1);
    expect(report.summary).toMatchObject({ completable: 2 });
    expect(report.packs?.[0].problems.map((one) => [one.code, one.severity, one.line, one.column, one.pointer])).toEqual([
      ['pack-missing-level', 'error', 1, 47, '/levels/1'],
      ['pack-repeated-level', 'error', 1, 54, '/levels/2'],
    ]);
    const built = await run('build', 'wrong', '--out', 'never', '--force', '--no-cache');
    expect(built.code).toBe(2);
    expect(built.stderr).toMatch(/did you mean "2-b"/);
    expect(() => readFileSync(join(cwd, 'never', 'index.html'))).toThrow();
    expect((await run('build', 'empty', '--out', 'never', '--no-cache')).stderr).toMatch(/lists no level/);
  });

  it.each(['pretty', 'github', 'junit', 'sarif', 'markdown'])('has its problems in the report %s', async (format) => {
    const { stdout, code } = await run('check', 'wrong', '--format', format, '--no-cache');
    expect(code).toBe(1);
    expect(stdout).toContain('pack-missing-level');
    expect(stdout).toMatch(/wrong\/pack\.json/);
    expect(stdout).toMatch(/2-bb/);
    const good = (await run('check', 'plain', '--format', format, '--no-cache')).stdout;
    expect(good).not.toContain('pack');
  });

  it('that is not valid is an error with its place, and puts nothing in order', async () => {
    const { report, code } = await checked('invalid');
    expect(code).toBe(1);
    expect(report.levels.map(({ file }) => file)).toEqual(['invalid/1-a.level.json', 'invalid/2-b.level.json']);
    expect(report.packs?.[0].name).toBe(null);
    expect(report.packs?.[0].problems).toEqual([expect.objectContaining({ code: 'trailing-comma', line: 1, column: 46 })]);
    expect((await run('fmt', 'invalid')).code).toBe(1);
  });

  it('follows the configuration: severities, and levels that are left out', async () => {
    const { stdout, code } = await gq(['check', '--format', 'json', '--no-cache'], { cwd: join(cwd, 'set') });
    const report = checkReportSchema.parse(JSON.parse(stdout));
    expect(code).toBe(1);
    expect(report.packs?.[0].problems.map(({ code, severity, message }) => [code, severity, message])).toEqual([
      ['pack-unlisted-level', 'error', '1 level of this folder is not listed: "2"'],
    ]);
    const warned = await run('check', 'ordered', '--no-cache', '--max-warnings', '0');
    expect(warned.code).toBe(1);
    expect((await run('check', 'ordered', '--no-cache', '--quiet')).stdout).not.toContain('pack-unlisted-level:');
  });

  it('is never taken for a level: by no command, named or by a pattern', async () => {
    for (const command of [
      'check',
      'simulate',
      'inspect',
      'render',
      'accuracy',
      'solve',
      'difficulty',
      'fix',
      'tune',
      'export',
      'plan',
    ]) {
      const more: Record<string, string[]> = {
        render: ['-o', 'p.svg'],
        tune: ['--set', 'pull=1.1x'],
        export: ['--to', 'tiled', '--out', 'tiled'],
        plan: ['--shards', '2', '-o', 'p.json'],
      };
      const { code, stderr } = await run(command, 'ordered/pack.json', ...(more[command] ?? []));
      expect([command, code]).toEqual([command, 2]);
      expect(stderr, command).toContain('is no level');
    }
    const { stdout } = await run('check', 'ordered/*.json', '--format', 'json', '--no-cache');
    expect(checkReportSchema.parse(JSON.parse(stdout)).levels.map(({ file }) => file)).toEqual([
      'ordered/1-a.level.json',
      'ordered/10-c.level.json',
      'ordered/2-b.level.json',
    ]);
  });

  it('is laid out by fmt, as part of its folder or by its name, and keeps what is ours', async () => {
    const file = join(cwd, 'ordered', 'pack.json');
    const before = readFileSync(file, 'utf8');
    writeFileSync(file, JSON.stringify({ ...JSON.parse(before), ...CLEAN }));
    expect((await run('fmt', 'ordered', '--check')).stdout).toContain('would change ordered/pack.json');
    expect((await run('fmt', 'ordered/pack.json')).code).toBe(0);
    expect((await run('fmt', 'ordered/pack.json', '--check')).code).toBe(0);
    const text = readFileSync(file, 'utf8');
    expect(JSON.parse(text)).toEqual({ ...JSON.parse(before), ...CLEAN });
    expect(text).toContain('\n    "world/1",\n');
    writeFileSync(file, before);
  });

  it('gives the order of a plan, whose merged report is that of the check alone', async () => {
    await run('plan', 'ordered', '--shards', '3', '-o', 'plan.json');
    for (const shard of ['0', '1', '2']) await run('check', '--plan', 'plan.json', '--shard', shard, '--out', 'results');
    const merged = await run('merge', 'results', '--plan', 'plan.json', '--format', 'json');
    const { report } = await checked('ordered');
    const levels = checkReportSchema.parse(JSON.parse(merged.stdout)).levels;
    expect(levels.map(({ file, verdict }) => [file, verdict])).toEqual(report.levels.map(({ file, verdict }) => [file, verdict]));
    // another order is another set: nothing is mixed up
    const file = join(cwd, 'ordered', 'pack.json');
    const before = readFileSync(file, 'utf8');
    writeFileSync(file, pack('1-a', '10-c', 'world/1'));
    const late = await run('check', '--plan', 'plan.json', '--shard', '0', '--out', 'late');
    writeFileSync(file, before);
    expect(late.code).toBe(2);
    expect(late.stderr).not.toBe('');
  });

  it('is written for generated levels in their order, and never over another one', async () => {
    const made = makeFiles({ 'orbits/01-b.level.json': fallThrough(), 'orbits/02-a.level.json': fallThrough() });
    const folder = join(made.directory, 'orbits');
    const keep = () => keepPack(folder, [join(folder, '01-b.level.json'), join(folder, '02-a.level.json')]);
    expect(keep()).toEqual({ file: join(folder, 'pack.json'), status: 'written' });
    const text = readFileSync(join(folder, 'pack.json'), 'utf8');
    expect(JSON.parse(text)).toEqual({ version: 1, name: 'orbits', levels: ['01-b', '02-a'] });
    expect((await gq(['fmt', 'orbits/pack.json', '--check'], { cwd: made.directory })).code).toBe(0);
    expect(keep().status).toBe('unchanged');
    writeFileSync(join(folder, 'pack.json'), pack());
    expect([keep().status, readFileSync(join(folder, 'pack.json'), 'utf8')]).toEqual(['in the way', pack()]);
    made.remove();
  });
});
