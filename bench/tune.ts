import { spawnSync } from 'node:child_process';
import { mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { LevelFile } from '../schema/index.ts';
import { atMost, compare, publish } from './harness.ts';
import { movedLevel } from './moved-level.ts';

const GQ = fileURLToPath(new URL('../cli/main.js', import.meta.url));
const SHIPPED = fileURLToPath(new URL('../../levels/', import.meta.url));
const LEVELS = 28;
const VALUES = 41;

/** Writes level files, made in turn from the shipped ones; repeated ones are moved by some px. */
function writeLevels(directory: string): void {
  const shipped = readdirSync(SHIPPED)
    .filter((name) => name.endsWith('.level.json'))
    .map((name) => JSON.parse(readFileSync(join(SHIPPED, name), 'utf8')) as LevelFile);
  for (let i = 0; i < LEVELS; i++) {
    const file = shipped[i % shipped.length];
    const shift = 64 * Math.floor(i / shipped.length);
    const moved = movedLevel(file, shift, 0);
    writeFileSync(join(directory, `${String(i).padStart(2, '0')}.level.json`), JSON.stringify(moved));
  }
}

/**
 * Tunes the directory.
 * @throws {Error} unless every level was replayed at every value
 */
function tune(directory: string): number {
  const args = ['tune', directory, '--sweep', `pull=0.8x..1.2x:${VALUES}`, '--jobs', '2', '--format', 'json'];
  const { stdout, stderr, status } = spawnSync(process.execPath, [GQ, ...args], { encoding: 'utf8', maxBuffer: 2 ** 28 });
  if (status !== 0) throw new Error(`expected gq tune to exit with 0, it exited with ${status}: ${stderr.slice(0, 2000)}`);
  const { levels } = JSON.parse(stdout) as { levels: { values: unknown[] }[] };
  const replayed = levels.reduce((sum, { values }) => sum + values.length, 0);
  if (replayed !== LEVELS * VALUES) throw new Error(`expected ${LEVELS * VALUES} results, found ${replayed}`);
  return replayed;
}

const directory = mkdtempSync(join(tmpdir(), 'gq-bench-tune-'));
try {
  writeLevels(directory);
  const names = { bare: 'node -e 0', tune: 'gq tune --jobs 2' };
  const measured = compare(
    [
      { name: names.bare, run: () => spawnSync(process.execPath, ['-e', '0']).pid },
      { name: names.tune, run: () => tune(directory) },
    ],
    { rounds: 15, sampleMs: 0, warmUpMs: 0 },
  );
  publish({
    title: `gq tune on ${LEVELS} levels at ${VALUES} values of the pull, thresholds included`,
    columns: ['', 's', 'quartiles'],
    rows: Object.values(names).map((name) => {
      const { median, q1, q3 } = measured.time(name);
      return [name, median / 1000, `${(q1 / 1000).toFixed(2)} - ${(q3 / 1000).toFixed(2)}`];
    }),
    claims: [atMost(`${LEVELS} levels at ${VALUES} values with --jobs 2, s`, measured.time(names.tune).median / 1000, 2)],
    notes: [`Medians of ${measured.rounds} interleaved runs, process start and JSON report included.`],
  });
} finally {
  rmSync(directory, { recursive: true, force: true });
}
