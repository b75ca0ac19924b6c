import { execFileSync } from 'node:child_process';
import { existsSync, lstatSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { afterAll, describe, expect } from 'vitest';
import { formatLevel, readLevel, solveReportSchema } from '../../schema/index.ts';
import { type Proof, verifyProof } from '../../solver/index.ts';
import { describeQuick, itQuick as it, itDeep } from '../depth.ts';
import { interruptAt } from '../interrupted/step.ts';
import { fallThrough, gq, gqProcess, MAIN, makeFiles } from './gq.ts';
import { inDirectory, narrowGap, shipped, withoutRuns, withoutTimes } from './levels.ts';

/** Runs a command in a terminal. */
const SCRIPT = '/usr/bin/script';

const NOTE = { 'x-note': 'kept', runs: [{ name: 'solution', holds: [[0, 5]] }] };
const files = makeFiles({
  'through.level.json': fallThrough(),
  'needle.level.json': narrowGap(),
  'first-swing.level.json': withoutRuns('02-first-swing'),
  'away.level.json': fallThrough({ blackHole: { x: 5000, y: 0 } }),
  'invalid.level.json': '{',
  'taken.level.json': fallThrough(NOTE),
});
const cwd = files.directory;
afterAll(files.remove);

const solve = (args: string, run = gq) => run(['solve', ...args.split(' ')], { cwd });
const report = ({ stdout }: { stdout: string }) => solveReportSchema.parse(JSON.parse(stdout));

describe('a run that is found', () => {
  it.each([
    [shipped('19-tailwind'), 'precise', 'all'],
    [shipped('07-nova-lane'), 'fast', '1'],
    [shipped('11-blind-date'), 'arcade', 'any'],
  ])('in %s under %s with %s minerals is confirmed by gq simulate, bit for bit', async (file, accuracy, minerals) => {
    const ended = await gq([
      'solve',
      file,
      '--accuracy',
      accuracy,
      '--minerals',
      minerals,
      '--objective',
      'first',
      '--effort',
      '20000000',
      '--jobs',
      '1',
      '--format',
      'json',
    ]);
    expect(ended).toMatchObject({ code: 0, stderr: '' });
    const found = report(ended);
    expect(found).toMatchObject({ found: true, accuracy, closest: null, impossible: null });
    const holds = found.holds?.map((hold) => hold.join('-')).join(',') || 'none';
    const { stdout } = await gq(['simulate', file, '--accuracy', accuracy, '--holds', holds, '--format', 'json']);
    const { outcome, time, tick, hash, minerals: collected } = JSON.parse(stdout);
    expect(found).toMatchObject({ outcome, time, tick, hash, minerals: collected });
    expect(outcome).toBe('completed');
    const wanted = minerals === 'all' ? 3 : minerals === 'any' ? 0 : Number(minerals);
    expect(new Set(collected.map((m: { index: number }) => m.index)).size).toBeGreaterThanOrEqual(wanted);
    expect(found.robustness?.slack).toHaveLength(2 * (found.holds?.length ?? 0));
  });

  it("is the level's own run if that reaches the goal and any run will do", async () => {
    const file = shipped('01-first-pull');
    const own = JSON.parse(readFileSync(file, 'utf8')).runs[0].holds;
    const found = report(await solve(`${file} --objective first --effort 40000 --format json`));
    expect(found).toMatchObject({ found: true, holds: own });
  });

  itDeep('is the same for any number of threads, with the same effort', async () => {
    const args = 'first-swing.level.json --objective robust --effort 300000 --count 2 --format json --jobs';
    const ended = await Promise.all([solve(`${args} 1`), solve(`${args} 3`, gqProcess)]);
    const [one, three] = ended.map(({ stdout }) => withoutTimes(stdout));
    expect(three).toBe(one);
    expect(JSON.parse(one).found).toBe(true);
  });

  it('comes with others if several are wanted; the best is first and at the top', async () => {
    const found = report(await solve('first-swing.level.json --objective time --effort 1000000 --count 3 --format json'));
    const { version, solutions = [], ...best } = found;
    expect(solutions.length).toBeGreaterThan(1);
    expect(version).toBe(1);
    expect(solutions[0]).toEqual(best);
    expect(new Set(solutions.map(({ holds }) => JSON.stringify(holds))).size).toBe(solutions.length);
  });

  it('is reported to people with its robustness', async () => {
    const { code, stdout, stderr } = await solve('through.level.json --effort 10000');
    expect({ code, stderr }).toEqual({ code: 0, stderr: '' });
    for (const part of [
      /^Straight through, precise\ncompleted at/,
      /\nholds {6}/,
      /\nsuccess {4}/,
      /\ncertified {2}/,
      /\nhash {7}[0-9a-f]{16}\n/,
      /seed 0\n$/,
    ])
      expect(stdout).toMatch(part);
  });
});

describeQuick('no run', () => {
  it('proved: prints a certificate that the checker confirms, with exit code 1', async () => {
    const ended = await solve('away.level.json --format json');
    expect(ended.code).toBe(1);
    const { found, holds, impossible, effort } = report(ended);
    expect({ found, holds, ticks: effort.ticks }).toEqual({ found: false, holds: null, ticks: 0 });
    const read = readLevel(fallThrough({ blackHole: { x: 5000, y: 0 } }));
    const proof = { ...impossible, about: { kind: 'blackHole' }, covers: ['precise'], maxTime: null } as unknown as Proof;
    expect(read.ok && verifyProof(read.level, proof)).toEqual({ ok: true });
    const pretty = await solve('away.level.json');
    expect(pretty.stdout).toContain('\nproved impossible: the black hole is');
  });

  it('not found: prints the effort and the closest run, which is a real run, with exit code 1', async () => {
    const ended = await solve('needle.level.json --effort 20000 --format json');
    expect(ended.code).toBe(1);
    const { found, closest, impossible, effort, robustness } = report(ended);
    expect({ found, impossible, robustness }).toEqual({ found: false, impossible: null, robustness: null });
    expect(effort.ticks).toBeGreaterThanOrEqual(20_000);
    expect(closest?.distance).toBeGreaterThan(0);
    const pretty = await solve('needle.level.json --effort 20000');
    expect(pretty).toMatchObject({ code: 1, stderr: '' });
    expect(pretty.stdout).toMatch(
      /no run found; this does not prove that there is none\n\neffort .*\nclosest +[\d.]+ px from the black hole/,
    );
  });

  it('with a custom setting is never called impossible', async () => {
    const { impossible } = report(await solve('away.level.json --integrator rk4 --rate 90 --effort 1000 --format json'));
    expect(impossible).toBeNull();
  });
});

describeQuick('--write', () => {
  const write = (name: string, more = '') => solve(`${name} --objective first --effort 1000000 --write${more}`);

  it('adds the run in the canonical layout and changes nothing else', async () => {
    const before = JSON.parse(inDirectory(cwd, 'taken.level.json'));
    const { code, stderr } = await write('taken.level.json');
    expect({ code, stderr }).toEqual({ code: 0, stderr: 'wrote run "solution-2" to taken.level.json\n' });
    const text = inDirectory(cwd, 'taken.level.json');
    const after = JSON.parse(text);
    expect(text).toBe(formatLevel(after));
    expect({ ...after, runs: after.runs.slice(0, 1) }).toEqual(before);
    expect(after.runs).toHaveLength(2);
    const check = await gq(['check', 'taken.level.json'], { cwd });
    expect(check.stdout).toMatch(/^completable/);
  });

  it('says so if the file already has the run', async () => {
    writeFileSync(join(cwd, 'twice.level.json'), fallThrough({ runs: undefined }));
    const first = await write('twice.level.json', ' --run mine');
    expect(first.stderr).toBe('wrote run "mine" to twice.level.json\n');
    const text = inDirectory(cwd, 'twice.level.json');
    const second = await write('twice.level.json');
    expect(second).toMatchObject({ code: 0, stderr: 'twice.level.json already has this run: "mine"\n' });
    expect(inDirectory(cwd, 'twice.level.json')).toBe(text);
  });

  it('writes through a link, which stays a link', async () => {
    writeFileSync(join(cwd, 'real.level.json'), fallThrough({ runs: undefined }));
    symlinkSync('real.level.json', join(cwd, 'link.level.json'));
    expect((await write('link.level.json')).code).toBe(0);
    expect(lstatSync(join(cwd, 'link.level.json')).isSymbolicLink()).toBe(true);
    expect(JSON.parse(inDirectory(cwd, 'real.level.json')).runs).toHaveLength(1);
  });

  it('writes nothing if nothing was found', async () => {
    const text = inDirectory(cwd, 'needle.level.json');
    const { code, stderr } = await solve('needle.level.json --effort 10000 --write');
    expect({ code, stderr }).toEqual({ code: 1, stderr: 'nothing was written: no run was found\n' });
    expect(inDirectory(cwd, 'needle.level.json')).toBe(text);
  });
});

it("evaluates the level's own runs even with a very short budget", async () => {
  const ended = await solve('through.level.json --budget 0.001 --format json');
  expect(ended.code).toBe(0);
  expect(report(ended)).toMatchObject({ found: true, outcome: 'completed' });
});

describeQuick('bad input', () => {
  it.each([
    ['through.level.json --minerals 2', 'has only 0 minerals'],
    ['through.level.json --minerals most', 'expected any, all or a whole number'],
    ['through.level.json --run mine', 'give --write as well'],
    ['taken.level.json --write --run solution', 'a run is already named "solution"'],
    [`through.level.json --write --run ${'x'.repeat(81)}`, 'expected a name of 1 to 80 characters, found 81'],
    ['through.level.json --budget 0', 'expected seconds: more than 0'],
    ['through.level.json --effort 0', 'expected a number of ticks'],
    ['through.level.json --count 0', 'expected a number of runs'],
    ['through.level.json --seed -1', 'expected a seed'],
    ['through.level.json --objective best', 'Allowed choices are robust, first, presses, time'],
    ['missing.level.json', "can't be read"],
  ])('gq solve %s: exit code 2 and a message that says what was expected', async (args, message) => {
    const { code, stdout, stderr } = await solve(args);
    expect({ code, stdout }).toEqual({ code: 2, stdout: '' });
    expect(stderr).toContain(message);
  });

  it('an invalid level is exit code 1', async () => {
    const { code, stdout, stderr } = await solve('invalid.level.json');
    expect({ code, stdout }).toEqual({ code: 1, stdout: '' });
    expect(stderr).toContain('truncated-json');
  });
});

describe.runIf(process.platform === 'linux')('a running search', () => {
  // no run of this level is so robust that the search ends by itself
  const ENDLESS = withoutRuns('17-watchdog');

  itDeep('ends on a signal, and nothing is reported or written', async () => {
    writeFileSync(join(cwd, 'stop.level.json'), ENDLESS);
    const ended = await gqProcess('solve stop.level.json --effort 1000000000 --jobs 1 --write --format json'.split(' '), {
      cwd,
      // the signal arrives together with the answer of a thread
      env: interruptAt({ of: 'message', number: 2, signals: ['SIGTERM'] }),
    });
    expect(ended).toEqual({ code: 143, signal: null, stdout: '', stderr: '' });
    expect(inDirectory(cwd, 'stop.level.json')).toBe(ENDLESS);
  });

  it('does not write to a file that has changed in the meantime, but reports the run', async () => {
    writeFileSync(join(cwd, 'changed.level.json'), fallThrough({ runs: undefined }));
    const other = fallThrough();
    const change = { path: join(cwd, 'changed.level.json'), text: other };
    const args = 'solve changed.level.json --objective first --effort 400000 --jobs 1 --write --format json';
    const ended = await gqProcess(args.split(' '), {
      cwd,
      env: interruptAt({ of: 'message', number: 1, write: change }),
    });
    expect(inDirectory(cwd, 'changed.level.json')).toBe(other);
    expect(report(ended).found).toBe(true);
    expect(ended.code).toBe(2);
    expect(ended.stderr).toContain('the file changed during the search, so nothing was written');
  });

  itDeep.runIf(existsSync(SCRIPT))('shows its progress on a terminal, and clears it', () => {
    // progress appears after half a second: here every look at the clock advances it by a second
    const slow = 'const now = performance.now(); let looks = 0; performance.now = () => now + 1000 * looks++;';
    const env = { ...process.env, NODE_OPTIONS: `--import=data:text/javascript,${encodeURIComponent(slow)}` };
    const command = `'${process.execPath}' '${MAIN}' solve needle.level.json --effort 20000 --jobs 1`;
    const terminal = execFileSync(SCRIPT, ['-qec', `${command} 2>&1 || true`, '/dev/null'], { cwd, env, encoding: 'utf8' });
    const [, ...lines] = terminal.split('\r\u001b[2K');
    expect(lines[0]).toMatch(/^solving, \d+ s, [\d.]+ million ticks: no run yet, closest [\d.]+ px; Ctrl-C ends$/);
    expect(lines.at(-1)).not.toContain('solving');
    expect(terminal).toContain('no run found');
  });
});
