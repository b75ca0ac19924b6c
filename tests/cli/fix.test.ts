import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, describe, expect, it } from 'vitest';
import { fixReportSchema, formatLevel, readLevel } from '../../schema/index.ts';
import { fallThrough, gq, makeFiles } from './gq.ts';
import { inDirectory, shipped, withoutTimes } from './levels.ts';

/** Her run passes 26 px beside the black hole. */
const ASIDE = { blackHole: { x: 170, y: 60, 'x-note': 'kept' }, 'x-mine': { a: [1] }, description: 'Reach it.' };
const files = makeFiles({
  'aside.level.json': fallThrough(ASIDE),
  'away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 }, runs: undefined }),
  'through.level.json': fallThrough(),
  'invalid.level.json': '{',
  // nothing pulls her far enough: no single change is enough within these ticks
  'hopeless.level.json': fallThrough({
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 9000, y: 0 },
    asteroids: [{ x: 5000, y: 5000, radius: 16 }],
    runs: undefined,
  }),
});
const cwd = files.directory;
afterAll(files.remove);

const fix = (args: string) => gq(['fix', ...args.split(' ')], { cwd });
const report = ({ stdout }: { stdout: string }) => fixReportSchema.parse(JSON.parse(stdout));

describe('gq fix', () => {
  it('gives proposals of different kinds, the smallest first, that say what to change', async () => {
    const ended = await fix('aside.level.json --count 8 --format json');
    expect(ended).toMatchObject({ code: 0, stderr: '' });
    const { verdict, proposals, impossible, isFinished } = report(ended);
    // she is bound to the line through her start and the asteroid
    expect({ verdict, code: impossible?.code, isFinished }).toEqual({
      verdict: 'impossible',
      code: 'line-trap',
      isFinished: true,
    });
    expect(proposals.map(({ size }) => size)).toEqual(proposals.map(({ size }) => size).sort((a, b) => a - b));
    const hole = proposals.find(({ kind, object }) => kind === 'move' && object?.kind === 'blackHole');
    expect(hole?.size).toBeCloseTo(26, 0);
    expect(hole?.run.time).toBeGreaterThan(0);
    expect(hole?.edits.every(({ pointer }) => /^\/blackHole\/[xy]$/.test(pointer))).toBe(true);
  });

  it('reads for people with verdict, sentence, size and run', async () => {
    const { stdout } = await fix('aside.level.json');
    for (const part of [/^Straight through, precise: \w+\n/, /\n1 {2}\S.*\.\n {3}\d+\.\d px; .*: completed at/, /, seed 0\n$/])
      expect(stdout).toMatch(part);
  });

  it('is the same for the same effort and seed', async () => {
    const args = 'aside.level.json --effort 300000 --seed 5 --format json';
    const [one, two] = [await fix(args), await fix(args)];
    expect(withoutTimes(one.stdout)).toBe(withoutTimes(two.stdout));
  });

  it('has nothing to fix where a run completes the level', async () => {
    const ended = await fix('through.level.json --format json');
    expect(ended.code).toBe(0);
    expect(report(ended)).toMatchObject({ verdict: 'completable', completedBy: 'hold', proposals: [] });
    expect((await fix('through.level.json')).stdout).toContain('nothing to fix: run "hold" completes the level\n');
  });

  it('finds nothing with too little effort, with exit code 1', async () => {
    const { code, stdout } = await fix('hopeless.level.json --effort 1');
    expect(code).toBe(1);
    expect(stdout).toMatch(/\nno fix found: a larger --budget or --effort tries more\n/);
  });

  it('follows the accuracy that is asked for', async () => {
    const { accuracy, proposals } = report(await fix('aside.level.json --accuracy arcade --effort 400000 --format json'));
    expect(accuracy).toBe('arcade');
    const [first] = proposals;
    expect(first.run.time).toBe(first.run.tick / 60);
  });
});

describe('gq fix --write', () => {
  it('changes what the proposal says and nothing else, and gq simulate and gq check confirm it', async () => {
    writeFileSync(join(cwd, 'write.level.json'), fallThrough(ASIDE));
    const { proposals } = report(await fix('write.level.json --effort 2000000 --format json'));
    const ended = await fix('write.level.json --effort 2000000 --write 2 --format json');
    expect(ended.code).toBe(0);
    expect(ended.stderr).toBe(`wrote proposal 2 to write.level.json: ${proposals[1].words}\n`);
    expect(report(ended).written).toBe(2);
    const expected = JSON.parse(fallThrough(ASIDE));
    for (const { pointer, to } of proposals[1].edits) {
      const path = pointer.slice(1).split('/');
      const last = path.pop() as string;
      path.reduce((at, key) => at[key], expected)[last] = to;
    }
    const text = inDirectory(cwd, 'write.level.json');
    expect(JSON.parse(text)).toEqual(expected);
    const read = readLevel(text);
    expect(read.ok && formatLevel(read.document.file)).toBe(text);
    const { holds, hash } = proposals[1].run;
    const asked = holds.map((hold) => hold.join('-')).join(',');
    const { stdout } = await gq(['simulate', 'write.level.json', '--holds', asked, '--format', 'json'], { cwd });
    expect(JSON.parse(stdout)).toMatchObject({ outcome: 'completed', hash });
    expect((await gq(['check', 'write.level.json'], { cwd })).stdout).toMatch(/^completable/);
  });

  it('adds a run that a search found, under a free name', async () => {
    writeFileSync(join(cwd, 'no-run.level.json'), fallThrough({ runs: [{ name: 'solution', holds: [] }] }));
    const ended = await fix('no-run.level.json --write');
    expect(ended.code).toBe(0);
    const { runs, blackHole } = JSON.parse(inDirectory(cwd, 'no-run.level.json'));
    expect(blackHole).toEqual({ x: 170, y: 0 });
    expect(runs.map(({ name }: { name: string }) => name)).toEqual(['solution', 'solution-2']);
    expect((await gq(['check', 'no-run.level.json'], { cwd })).code).toBe(0);
  });

  it('puts the other holds of a run in its place', async () => {
    const text = JSON.parse(inDirectory('/', shipped('02-first-swing').slice(1)));
    const holds = text.runs[0].holds.map(([press, release]: [number, number]) => [press, release - 30]);
    writeFileSync(
      join(cwd, 'early.level.json'),
      JSON.stringify({ ...text, $schema: undefined, runs: [{ name: 'mine', holds }] }),
    );
    const { proposals } = report(await fix('early.level.json --format json --write'));
    expect(proposals[0]).toMatchObject({ kind: 'run', size: 0, edits: [], run: { origin: 'adjusted', name: 'mine' } });
    const { runs } = JSON.parse(inDirectory(cwd, 'early.level.json'));
    expect(runs).toEqual([{ name: 'mine', holds: proposals[0].run.holds }]);
  });

  it('writes nothing where there is no such proposal', async () => {
    const text = inDirectory(cwd, 'through.level.json');
    expect(await fix('through.level.json --write')).toMatchObject({
      code: 0,
      stderr: 'nothing was written: there is nothing to fix\n',
    });
    expect(inDirectory(cwd, 'through.level.json')).toBe(text);
    const { code, stderr } = await fix('hopeless.level.json --effort 1 --write');
    expect({ code, stderr }).toEqual({ code: 1, stderr: 'nothing was written: there is no proposal 1\n' });
  });
});

describe('bad input', () => {
  it.each([
    ['aside.level.json --write 4', '--write 4: there are at most 3 proposals: give --count 4 as well'],
    ['aside.level.json --write 0', 'expected the number of a proposal: a whole number from 1 to 20'],
    ['aside.level.json --count 0', 'expected a number of proposals: a whole number from 1 to 20'],
    ['aside.level.json --effort 0', 'expected a number of ticks'],
    ['missing.level.json', "can't be read"],
  ])('gq fix %s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await fix(args);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });

  it('a file that is no level: its problems, with exit code 1', async () => {
    const { code, stderr } = await fix('invalid.level.json');
    expect(code).toBe(1);
    expect(stderr).toContain('invalid.level.json:1:2');
  });
});
