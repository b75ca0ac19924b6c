import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { atMost, compare, define, GQ, PROJECT, timeCells } from './harness/index.ts';

/**
 * Starts Node with `args` and waits for its end.
 * @throws {Error} if it fails
 */
function start(args: readonly string[]): number {
  const { status, stderr } = spawnSync(process.execPath, args, { encoding: 'utf8' });
  if (status !== 0) throw new Error(`expected \`node ${args.join(' ')}\` to exit with 0, it exited with ${status}: ${stderr}`);
  return 1;
}

const STARTS = {
  'node -e 0': ['-e', '0'],
  'gq --version': [GQ, '--version'],
  'gq check LEVEL': [GQ, 'check', join(PROJECT, 'levels/16-firewalk.level.json'), '--no-cache'],
};

export const bench = define({
  what: 'gq --version and the check of one level against bare node',
  options: {},
  claims: { version: atMost(60, 'gq --version over node -e 0, ms'), check: atMost(3.5, 'gq check of a level, times node -e 0') },
  run() {
    const measured = compare(
      Object.entries(STARTS).map(([name, args]) => ({ name, run: () => start(args) })),
      { rounds: 41, sampleMs: 0, warmUpMs: 200 },
    );
    const over = (name: string) => measured.difference(name, 'node -e 0').median;
    const times = (name: string) => measured.ratio(name, 'node -e 0').median;
    return {
      title: 'Time to start, process and all',
      columns: ['', 'ms', 'quartiles', 'ms over bare node', 'times bare node'],
      rows: Object.keys(STARTS).map((name) => [...timeCells(measured, name), over(name), times(name)]),
      measured: { version: over('gq --version'), check: times('gq check LEVEL') },
      notes: [`Medians of ${measured.rounds} interleaved starts.`],
    };
  },
});
