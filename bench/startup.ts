import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { atMost, compare, publish } from './harness.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));

/**
 * Starts Node with `args` and waits for its end.
 * @throws {Error} if it fails
 */
function start(args: readonly string[]): number {
  const { status, stderr } = spawnSync(process.execPath, args, { encoding: 'utf8' });
  if (status !== 0) throw new Error(`expected \`node ${args.join(' ')}\` to exit with 0, it exited with ${status}: ${stderr}`);
  return 1;
}

const names = { bare: 'node -e 0', version: 'gq --version', help: 'gq check --help' };
const measured = compare(
  [
    { name: names.bare, run: () => start(['-e', '0']) },
    { name: names.version, run: () => start([GQ, '--version']) },
    { name: names.help, run: () => start([GQ, 'check', '--help']) },
  ],
  { rounds: 41, sampleMs: 0, warmUpMs: 200 },
);

publish({
  title: 'Time to start, process and all',
  columns: ['', 'ms', 'quartiles', 'ms over bare node'],
  rows: Object.values(names).map((name) => {
    const { median, q1, q3 } = measured.time(name);
    return [name, median, `${q1.toFixed(1)} - ${q3.toFixed(1)}`, measured.difference(name, names.bare).median];
  }),
  claims: [atMost('gq --version over node -e 0, ms', measured.difference(names.version, names.bare).median, 60)],
  notes: [`Medians of ${measured.rounds} interleaved starts.`],
});
