import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { DEFAULT_ACCURACY } from '../engine/index.ts';
import type { LevelFile } from '../schema/index.ts';
import { atMost, compare, optionValue, publish } from './harness.ts';
import { movedLevel } from './moved-level.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
/** The shipped levels, or those of a directory given with --levels. */
const SHIPPED = optionValue('--levels') ?? fileURLToPath(new URL('../../levels/', import.meta.url));
const ACCURACY = optionValue('--accuracy') ?? DEFAULT_ACCURACY;
const FILES = 1000;

/** Writes 1,000 level files into `directory`, made in turn from the shipped levels that have a run. */
function writeLevels(directory: string): void {
  const shipped = readdirSync(SHIPPED)
    .filter((name) => name.endsWith('.level.json'))
    .map((name) => JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')) as LevelFile)
    .filter((file) => (file.runs?.length ?? 0) > 0);
  if (shipped.length === 0) throw new Error(`expected level files with a run in ${SHIPPED}, found none`);
  for (let i = 0; i < FILES; i++) {
    const name = `Moved ${i}`;
    const file = shipped[i % shipped.length];
    const moved = { ...movedLevel(file, i, -2 * i), name, runs: file.runs?.slice(0, 1) };
    writeFileSync(join(directory, `${String(i).padStart(4, '0')}.level.json`), `${JSON.stringify(moved, null, 2)}\n`);
  }
}

/**
 * Checks the directory.
 * @throws {Error} unless every file was checked and each is completable
 */
function check(directory: string): number {
  const { stdout, stderr, status } = spawnSync(
    process.execPath,
    [GQ, 'check', directory, '--jobs', '2', '--accuracy', ACCURACY, '--format', 'json'],
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
  writeLevels(levels);
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
