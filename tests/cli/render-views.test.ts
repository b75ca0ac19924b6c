import { afterAll, describe, expect, it } from 'vitest';
import { fallThrough, gq, makeFiles } from './gq.ts';
import { narrowGap, shipped } from './levels.ts';

const files = makeFiles({
  'away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 }, runs: undefined }),
  'needle.level.json': narrowGap(),
  'through.level.json': fallThrough(),
});
const cwd = files.directory;
afterAll(files.remove);

const render = (args: string) => gq(['render', ...args.split(' '), '-o', '-'], { cwd });
const count = (svg: string, kind: string): number => svg.split(`data-kind="${kind}"`).length - 1;

describe('gq render', () => {
  it.each([
    [`${shipped('16-firewalk')} --all-runs`, 'way', 2],
    [`${shipped('16-firewalk')} --fan 3`, 'fan', 1],
    [`${shipped('16-firewalk')} --fan 40`, 'fan-failed', 1],
    ['needle.level.json --explored --effort 20000', 'explored', 1],
    ['needle.level.json --closest --effort 20000', 'gap', 1],
    ['needle.level.json --closest --explored --effort 20000', 'gap', 1],
    ['through.level.json --explored --run hold --effort 50000', 'way', 1],
    ['away.level.json --proof', 'proof', 1],
  ])('%s draws %s', async (args, kind, expected) => {
    const { code, stdout, stderr } = await render(args);
    expect({ code, stderr, drawn: count(stdout, kind) }).toEqual({ code: 0, stderr: '', drawn: expected });
    expect(stdout).not.toMatch(/NaN|undefined|Infinity/);
  });

  it('--solve says if it has found fewer runs than requested, wherever the picture goes', async () => {
    const [whole, part] = await Promise.all([
      render('through.level.json --solve 1 --effort 10000'),
      // far too little for a search from nothing
      render(`${shipped('12-detour')} --solve 4 --effort 100`),
    ]);
    expect([whole.code, whole.stderr, count(whole.stdout, 'ways')]).toEqual([0, '', 1]);
    for (const { stdout } of [whole, part]) expect(stdout).not.toMatch(/NaN|undefined|Infinity/);
    expect([part.code, count(part.stdout, 'ways')]).toEqual([0, 1]);
    expect(part.stderr).toMatch(/^found [123] of 4 clearly different runs: .* --effort .* --seed .*\n$/);
    expect(part.stdout).toMatch(/<title>[^<]*: [123] of 4 runs found</);
  });

  it('draws the same picture every time', async () => {
    const args = 'needle.level.json --closest --explored --effort 20000 --seed 3';
    const [one, two] = await Promise.all([render(args), render(args)]);
    expect(two.stdout).toBe(one.stdout);
  });

  it.each([
    ['through.level.json --proof', 'no proof was found'],
    ['needle.level.json --all-runs', 'the level has no run to draw'],
    ['needle.level.json --solve 1 --effort 1000', 'no run was found'],
  ])('%s: exit code 1 if there is nothing to draw', async (args, message) => {
    const { code, stdout, stderr } = await render(args);
    expect({ code, stdout }).toEqual({ code: 1, stdout: '' });
    expect(stderr).toContain(message);
  });

  it.each([
    ['through.level.json --all-runs --proof', '--all-runs and --proof cannot be combined'],
    ['through.level.json --all-runs --run hold', '--run and --all-runs cannot be combined'],
    ['through.level.json --fan 2 --no-run', '--no-run and --fan cannot be combined'],
    ['through.level.json --fan 0', 'expected a number of ticks'],
    ['through.level.json --explored --minerals 1', 'has only 0 minerals'],
    ['needle.level.json --fan 2', 'the level has no run'],
  ])('%s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await render(args);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });
});
