import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { afterAll, describe, expect, it } from 'vitest';
import { checkReportSchema } from '../../schema/index.ts';
import { itDeep } from '../depth.ts';
import { runWhole, SIGNALLED_COMMANDS, signalAt } from '../interrupted/signalled-command.ts';
import { interruptAt } from '../interrupted/step.ts';
import { fallThrough, gqProcess, makeFiles } from './gq.ts';
import { narrowGap } from './levels.ts';

// Long checks (--solve, --require-slack) end early on the first signal with what is checked; a second one ends them at once.

const QUICK = ['a', 'b', 'c'].map((name) => `levels/${name}.level.json`);
const SLOW = ['m', 'n'].map((name) => `levels/${name}.level.json`);
const files = makeFiles({
  ...Object.fromEntries(QUICK.map((name) => [name, fallThrough()])),
  ...Object.fromEntries(SLOW.map((name) => [name, narrowGap()])),
});
afterAll(() => files.remove());
const cwd = files.directory;
const FOREVER = ['check', '--solve', '--budget', '20', '--jobs', '1'];

/** Sends signals when the search of the first slow level is about to begin. The first task goes to a worker that is not online yet. */
const whenSearching = (...signals: NodeJS.Signals[]) => ({
  cwd,
  env: interruptAt({ of: 'postMessage', after: 'online', number: QUICK.length, signals }),
});

describe.runIf(process.platform !== 'win32')('an interrupted gq check --solve', () => {
  it('reports what is checked in every report, and what is not', async () => {
    const args = [...FOREVER, '--reporter', 'json=out/r.json'];
    const ended = await gqProcess(args, whenSearching('SIGINT', 'SIGINT'));
    // the second one is the first, passed on by npx
    expect(ended).toMatchObject({ code: 130, signal: null, stderr: '' });
    expect(ended.stdout).toContain(
      '3 levels: 3 completable\ninterrupted by a signal: 2 levels are not checked:\n  - levels/m.level.json\n',
    );
    const report = checkReportSchema.parse(JSON.parse(readFileSync(join(cwd, 'out/r.json'), 'utf8')));
    expect(report).toMatchObject({ interrupted: true, unchecked: SLOW, summary: { completable: 3 } });
    expect(report.levels.map(({ file }) => file)).toEqual(QUICK);
  });

  itDeep('ends at once on a second signal, without a report', async () => {
    const ended = await gqProcess([...FOREVER, '--reporter', 'json=second/r.json'], whenSearching('SIGINT', 'SIGTERM'));
    expect(ended).toEqual({ code: 143, signal: null, stdout: '', stderr: '' });
    expect(existsSync(join(cwd, 'second'))).toBe(false);
  });

  itDeep('ends with a whole report or none at any moment', async () => {
    const all = [...QUICK, ...SLOW];
    await fc.assert(
      fc.asyncProperty(fc.integer({ min: 0, max: 900 }), fc.constantFrom('SIGINT', 'SIGTERM'), async (ms, signal) => {
        const before = readdirSync(cwd, { recursive: true }).sort();
        const ended = await gqProcess([...FOREVER, '--format', 'json'], {
          cwd,
          during: (child) => void setTimeout(() => child.kill(signal), ms),
        });
        expect(ended.stderr).toBe('');
        expect(ended.signal ?? (ended.code === 130 ? 'SIGINT' : ended.code === 143 ? 'SIGTERM' : ended.code)).toBe(signal);
        if (ended.stdout !== '') {
          const { levels, unchecked, interrupted } = checkReportSchema.parse(JSON.parse(ended.stdout));
          expect(interrupted).toBe(true);
          expect([...levels.map(({ file }) => file), ...unchecked].sort()).toEqual(all);
        }
        expect(readdirSync(cwd, { recursive: true }).sort()).toEqual(before);
      }),
      { numRuns: 3, endOnFailure: true },
    );
  });

  itDeep('writes nothing else, whatever step the signal comes at', async () => {
    const whole = await runWhole(SIGNALLED_COMMANDS['check --require-slack']);
    await fc.assert(
      fc.asyncProperty(fc.noBias(fc.integer({ min: 0, max: 2 ** 30 - 1 })), async (part) => {
        const step = 1 + Math.floor((part / 2 ** 30) * whole.steps);
        expect((await signalAt(whole, step, ['SIGINT'])) ?? [], `at step ${step} of ${whole.steps}`).toEqual([]);
      }),
      { numRuns: 2, endOnFailure: true },
    );
  });
});
