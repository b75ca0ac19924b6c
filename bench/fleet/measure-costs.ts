import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { copiedLevels } from '../copied-levels.ts';
import { runGq } from '../gq-process.ts';
import { spread } from '../harness.ts';
import { randomLevel } from '../random-set/index.ts';
import type { LevelCosts, Measured } from './assumptions.ts';

/** Levels of the sets whose difference is what a level costs. */
const FEW = 1000;
const MANY = 10_000;
/** Scanning is fast, so it needs more of them. */
const VERY_MANY = 50_000;
const ROUNDS = 3;
/** Levels of the random set that are searched, and most ticks for each. */
const SEARCHED = 200;
const EFFORT = 5_000_000;
/** A shard of so many has hardly a level of its own. */
const MOST_SHARDS = 10_000;

const MS = /"ms":([-+.e\d]+),"result":/g;

/** Measures what gq costs by running it, as processor time: other work of the machine disturbs it less than the clock. */
export function measureCosts(): Measured {
  const folder = mkdtempSync(join(tmpdir(), 'gq-bench-fleet-'));
  const at = (name: string): string => join(folder, name);
  const gq = (codes: readonly number[], ...args: readonly string[]): number => runGq(folder, codes, args).processor;
  const write = (name: string, levels: readonly object[]): void =>
    writeFileSync(at(name), levels.map((level) => `${JSON.stringify(level)}\n`).join(''));
  const plan = (set: string, shards: number, ...options: readonly string[]): number =>
    gq([0], 'plan', set, '--shards', `${shards}`, '--force', ...options);
  /** Does the first shard of the last plan. */
  const shard = (out: string): number => {
    rmSync(at(out), { recursive: true, force: true });
    return gq([0], 'check', '--plan', 'plan.json', '--shard', '0', '--out', out, '--jobs', '1');
  };
  const median = (work: () => number): number => spread(Array.from({ length: ROUNDS }, work)).median;
  /** The costs of the levels of a result, s, scaled such that their sum is processor time. */
  const levelCosts = (out: string, processor: number): LevelCosts => {
    const ms = [...readFileSync(join(at(out), 'shard-0.ndjson'), 'utf8').matchAll(MS)].map(([, text]) => Number(text));
    const sum = ms.reduce((total, one) => total + one, 0);
    return ms.map((one) => (one / sum) * processor).sort((a, b) => b - a);
  };
  try {
    const levels = copiedLevels(VERY_MANY);
    for (const size of [1, FEW, MANY, VERY_MANY]) write(`${size}.ndjson`, levels.slice(0, size));
    write(
      'searched.ndjson',
      Array.from({ length: SEARCHED }, (_, seed) => randomLevel(seed)),
    );
    plan('1.ndjson', 1);
    const start = median(() => shard('one'));

    // one shard of everything, then its merge
    const [few, many] = [FEW, MANY].map((size) => {
      plan(`${size}.ndjson`, 1);
      const checked = median(() => shard('all'));
      const merged = median(() => gq([0], 'merge', 'all', '--plan', 'plan.json', '--format', 'json', '-o', 'merged.json'));
      return { checked, merged };
    });
    const replay = levelCosts('all', ((many.checked - few.checked) / (MANY - FEW)) * MANY);

    const [scanFew, scanMany] = [FEW, VERY_MANY].map((size) => ({
      planned: median(() => plan(`${size}.ndjson`, MOST_SHARDS)),
      scanned: median(() => shard('none')),
    }));
    const more = VERY_MANY - FEW;

    plan('searched.ndjson', 1, '--solve', '--effort', `${EFFORT}`);
    const search = levelCosts('searched', shard('searched') - start);
    return {
      replay,
      search,
      effort: EFFORT,
      start,
      scan: (scanMany.scanned - scanFew.scanned) / more,
      plan: (scanMany.planned - scanFew.planned) / more,
      merge: (many.merged - few.merged) / (MANY - FEW),
    };
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}
