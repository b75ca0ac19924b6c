import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { DEFAULT_ACCURACY } from '../engine/index.ts';
import { writeCopies } from './copied-levels.ts';
import { atMost, compare, optionValue, publish } from './harness.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
const ACCURACY = optionValue('--accuracy') ?? DEFAULT_ACCURACY;
const FILES = 1000;

/**
 * Checks the directory.
 * @throws {Error} unless every file was checked and each is completable
 */
function check(directory: string): number {
  const { stdout, stderr, status } = spawnSync(
    process.execPath,
    [GQ, 'check', directory, '--no-cache', '--jobs', '2', '--accuracy', ACCURACY, '--format', 'json'],
    { encoding: 'utf8', maxBuffer: 2 ** 30 },
  );
  if (status !== 0) throw new Error(`expected gq check to exit with 0, it exited with ${status}: ${stderr.slice(0, 2000)}`);
  const { summary } = JSON.parse(stdout) as { summary: Record<string, number> };
  if (summary.completable !== FILES) throw new Error(`expected ${FILES} completable levels, found ${JSON.stringify(summary)}`);
  return summary.completable;
}

const directory = mkdtempSync(join(tmpdir(), 'gq-bench-check-'));
try {
  const levels = join(directory, 'levels');
  mkdirSync(levels);
  writeCopies(levels, FILES);
  const names = { bare: 'node -e 0', check: 'gq check --jobs 2' };
  const measured = compare(
    [
      { name: names.bare, run: () => spawnSync(process.execPath, ['-e', '0']).pid },
      { name: names.check, run: () => check(levels) },
    ],
    { rounds: 15, sampleMs: 0, warmUpMs: 0 },
  );
  publish({
    title: `gq check on ${FILES} level files, a run each under ${ACCURACY}, process start and JSON report included`,
    columns: ['', 's', 'quartiles', 'levels a second'],
    rows: Object.values(names).map((name) => {
      const { median, q1, q3 } = measured.time(name);
      return [
        name,
        median / 1000,
        `${(q1 / 1000).toFixed(2)} - ${(q3 / 1000).toFixed(2)}`,
        name === names.check ? (1000 * FILES) / median : null,
      ];
    }),
    claims: [atMost(`${FILES} files with --jobs 2, s`, measured.time(names.check).median / 1000, 4)],
    notes: [
      `Medians of ${measured.rounds} interleaved checks. The files are the shipped levels, each moved as a whole by some px.`,
    ],
  });
} finally {
  rmSync(directory, { recursive: true, force: true });
}
