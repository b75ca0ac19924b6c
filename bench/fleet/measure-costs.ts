import { readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { randomLevel } from '../../tests/scenes/random-set/index.ts';
import { copiedLevels, inFolder, median as medianOf, runGq, sum, writeLines } from '../harness/index.ts';
import type { LevelCosts, Measured } from './assumptions.ts';

/** Levels of the sets whose difference is what a level costs: in both, the code is warm. */
const FEW = 5000;
const MANY = 40_000;
const ROUNDS = 3;
/** Levels of the random set that are searched, and most ticks for each. */
const SEARCHED = 200;
const EFFORT = 5_000_000;
/** A shard of so many has hardly a level of its own. */
const MOST_SHARDS = 10_000;

const MS = /"ms":([-+.e\d]+),"result":/g;

/** Measures what gq costs by running it, as processor time: other work of the machine disturbs it less than the clock. */
export const measureCosts = (): Promise<Measured> =>
  inFolder('fleet', (folder) => {
    const at = (name: string): string => join(folder, name);
    const gq = (...args: readonly string[]): number => runGq(folder, ...args).processor;
    const plan = (set: string, shards: number, ...options: readonly string[]): number =>
      gq('plan', set, '--shards', `${shards}`, '--force', ...options);
    /** Does the first shard of the last plan. */
    const shard = (out: string): number => {
      rmSync(at(out), { recursive: true, force: true });
      return gq('check', '--plan', 'plan.json', '--shard', '0', '--out', out, '--jobs', '1');
    };
    const median = (work: () => number): number => medianOf(Array.from({ length: ROUNDS }, work));
    /** The costs of the levels of a result, s, scaled such that their sum is processor time. */
    const levelCosts = (out: string, processor: number): LevelCosts => {
      const ms = [...readFileSync(join(at(out), 'shard-0.ndjson'), 'utf8').matchAll(MS)].map(([, text]) => Number(text));
      const all = sum(ms);
      return ms.map((one) => (one / all) * processor).sort((a, b) => b - a);
    };
    const levels = copiedLevels(MANY);
    for (const size of [1, FEW, MANY]) writeLines(at(`${size}.ndjson`), levels.slice(0, size));
    writeLines(
      at('searched.ndjson'),
      Array.from({ length: SEARCHED }, (_, seed) => randomLevel(seed)),
    );
    plan('1.ndjson', 1);
    const start = median(() => shard('one'));
    const [few, many] = [FEW, MANY].map((size) => {
      const planned = median(() => plan(`${size}.ndjson`, MOST_SHARDS));
      const scanned = median(() => shard('none'));
      plan(`${size}.ndjson`, 1);
      const checked = shard('all');
      const merged = median(() => gq('merge', 'all', '--plan', 'plan.json', '--format', 'json', '-o', 'merged.json'));
      return { planned, scanned, checked, merged };
    });
    const aLevel = (of: keyof typeof few): number => (many[of] - few[of]) / (MANY - FEW);
    const replay = levelCosts('all', aLevel('checked') * MANY);

    plan('searched.ndjson', 1, '--solve', '--effort', `${EFFORT}`);
    const search = levelCosts('searched', shard('searched') - start);
    return {
      replay,
      search,
      effort: EFFORT,
      start,
      scan: aLevel('scanned'),
      plan: aLevel('planned'),
      merge: aLevel('merged'),
    };
  });
