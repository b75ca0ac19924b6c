import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { runWhole, SIGNALLED_COMMANDS, signalAt } from '../interrupted/signalled-command.ts';
import { once } from '../once.ts';

// A signal ends every command with 130 or 143, at whatever step it arrives, and nothing is written afterwards. This test draws
// a step of a command of each kind, with one thread; `npm run bench -- soak --attack signals` tries all of them.

const wholeRun = once((name: keyof typeof SIGNALLED_COMMANDS) =>
  runWhole(SIGNALLED_COMMANDS[name].replace('--jobs 2', '--jobs 1')),
);

const SIGNALS: readonly (readonly NodeJS.Signals[])[] = [['SIGINT'], ['SIGTERM'], ['SIGINT', 'SIGTERM', 'SIGINT']];

// one that reports and keeps its reports, one with threads that share a search, one with a pool of threads, one that writes, one
// that takes back
const DRAWN = ['check --cache-dir', 'solve', 'generate', 'fmt', 'import'] as const;

describe.runIf(process.platform !== 'win32')('a signal at any step', () => {
  it.each(['fmt', 'import'] as const)('of gq %s that writes a file: the file is finished', async (name) => {
    const whole = await wholeRun(name);
    // the content is written, and the file not yet in its place
    expect(await signalAt(whole, 1, ['SIGTERM'], 'fsyncSync')).toEqual([]);
  });

  it('of gq check that writes its cache: each file of it is whole, and no other follows', async () => {
    const whole = await wholeRun('check --cache-dir');
    const files = Object.keys(whole.after).filter((name) => name.startsWith('work/cache/deep/'));
    await fc.assert(
      fc.asyncProperty(fc.integer({ min: 1, max: files.length }), fc.constantFrom(...SIGNALS), async (number, signals) => {
        expect(await signalAt(whole, number, signals, 'renameSync')).toEqual([]);
      }),
      { numRuns: 2, endOnFailure: true },
    );
  });

  it.each(DRAWN)('of gq %s', async (name) => {
    const whole = await wholeRun(name);
    let heard = 0;
    const fraction = fc.noBias(fc.integer({ min: 0, max: 2 ** 30 - 1 }));
    await fc.assert(
      fc.asyncProperty(fraction, fc.constantFrom(...SIGNALS), async (part, signals) => {
        const step = 1 + Math.floor((part / 2 ** 30) * whole.steps);
        const wrong = await signalAt(whole, step, signals);
        if (wrong !== null) heard++;
        expect(wrong ?? [], `at step ${step} of ${whole.steps}`).toEqual([]);
      }),
      { numRuns: 1, endOnFailure: true },
    );
    // the number of steps varies slightly with the threads: the last ones may be missing
    expect(heard).toBeGreaterThan(0);
  });
});
