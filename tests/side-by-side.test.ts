import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { afterEach, beforeEach, expect, it } from 'vitest';
import { until } from './until.ts';

// .ci/side-by-side.mjs runs the steps of CI

const SCRIPT = join(import.meta.dirname, '..', '.ci', 'side-by-side.mjs');

let folder = '';
beforeEach(() => {
  folder = mkdtempSync(join(tmpdir(), 'gq-steps-'));
});
afterEach(() => rmSync(folder, { recursive: true, force: true }));

const has = (name: string): boolean => existsSync(join(folder, name));

/** Runs steps to their end; `during` may send a signal. Times are left out of what it prints. */
function steps(atOnce: number, lines: readonly string[], during?: (send: (signal: NodeJS.Signals) => void) => Promise<void>) {
  return new Promise<{ code: number | null; stdout: string }>((resolve, reject) => {
    const child = spawn(process.execPath, [SCRIPT, String(atOnce)], { cwd: folder, stdio: ['pipe', 'pipe', 'inherit'] });
    let stdout = '';
    child.stdout.on('data', (piece: Buffer) => (stdout += piece.toString()));
    child.on('error', reject);
    child.on('close', (code) => resolve({ code, stdout: stdout.replace(/\d+ s$/gm, 'N s').replace(/\d+ s([, ])/g, 'N s$1') }));
    child.stdin.end(lines.join('\n'));
    during?.((signal) => child.kill(signal)).catch(reject);
  });
}

it('prints each step whole, when it ends', async () => {
  // the second waits for the first to begin, the first for the second to end
  const first = 'echo one; touch began; until [ -e ended ]; do sleep 0.01; done; echo two';
  const second = 'until [ -e began ]; do sleep 0.01; done; echo three >&2; touch ended';
  const { code, stdout } = await steps(2, [`first: ${first}`, '', `second: ${second}`, 'third: echo four']);
  expect(code).toBe(0);
  const [, ...printed] = stdout.split('\n== ');
  const last = printed.pop() as string;
  expect([...printed, last.replace('\nall passed in N s\n', '')].sort()).toEqual([
    'first: passed in N s\none\ntwo\n',
    'second: passed in N s\nthree\n',
    'third: passed in N s\nfour\n',
  ]);
  expect(last).toMatch(/\nall passed in N s\n$/);
});

it('runs no more at once than it is told', async () => {
  const step = 'mkdir busy; sleep 0.05; rmdir busy';
  expect(await steps(1, [`a: ${step}`, `b: ${step}`, `c: ${step}`])).toMatchObject({ code: 0 });
});

it('goes on with the others when one fails, prints what failed last, and fails as the first did', async () => {
  const long = 'until [ -e failed ]; do sleep 0.01; done; echo so far';
  const ended = await steps(1, ['bad: echo why; touch failed; exit 3', `long: ${long}`, 'worse: echo no; exit 4']);
  expect(ended).toEqual({
    code: 3,
    stdout:
      '\n== long: passed in N s\nso far\n\n== bad: FAILED after N s with 3\nwhy\n\n== worse: FAILED after N s with 4\nno\n\nfailed: bad, worse in N s\n',
  });
});

it('ends all steps with what they started, and itself, when it gets a signal', async () => {
  const long = 'sleep 600 & echo $! > process; touch began; wait';
  const ended = await steps(2, [`one: ${long}`, 'two: sleep 600', 'three: touch never'], async (send) => {
    await until(() => has('began'));
    send('SIGTERM');
  });
  expect(ended).toMatchObject({ code: 143, stdout: expect.stringContaining('== two: ended after N s, because of SIGTERM') });
  expect(has('never')).toBe(false);
  await until(() => !isAlive(Number(readFileSync(join(folder, 'process'), 'utf8'))));
});

it('refuses what is no step, and no steps', async () => {
  expect((await steps(1, ['a step without a name'])).code).toBe(1);
  expect((await steps(1, [])).code).toBe(1);
});

function isAlive(id: number): boolean {
  try {
    process.kill(id, 0);
    return true;
  } catch {
    return false;
  }
}
