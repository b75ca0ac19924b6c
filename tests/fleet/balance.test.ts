import { createHash } from 'node:crypto';
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import fc from 'fast-check';
import { expect, it } from 'vitest';
import { balance, Costs, MOST_ASSIGNED, NumberTable } from '../../cli/fleet/balance.ts';
import { keyOfHash } from '../../cli/fleet/digest.ts';
import { gq } from '../cli/gq.ts';
import { itDeep, itQuick } from '../depth.ts';
import { levelTexts, makeSet, merge, planSet, resultLines, runShard } from './sets.ts';

const hashOf = (text: string): Buffer => createHash('sha256').update(text).digest();
const keyText = (text: string): string => keyOfHash(hashOf(text)).toString(16).padStart(12, '0');

/** The first levels have cost these. */
function costsOf(ms: readonly number[]): Costs {
  const costs = new Costs();
  for (const [i, one] of ms.entries()) costs.set(`${i}`, one);
  return costs;
}

async function* entries(texts: readonly string[]) {
  for (const [i, text] of texts.entries()) yield { name: `${i}`, content: Buffer.from(text) };
}

it('spreads levels by cost: each once, no shard beyond 4/3 of the best that is possible', async () => {
  const cost = fc.oneof(fc.double({ min: 0.1, max: 5, noNaN: true }), fc.double({ min: 100, max: 5000, noNaN: true }));
  await fc.assert(
    fc.asyncProperty(fc.array(cost, { minLength: 1, maxLength: 200 }), fc.integer({ min: 1, max: 12 }), async (costs, shards) => {
      const texts = costs.map((_, i) => `level ${i}`);
      const { assigned, expected, known } = await balance(entries(texts), costsOf(costs), shards);
      expect(known).toBe(costs.length);
      expect(assigned.flat().sort()).toEqual(texts.map(keyText).sort());
      const loads = assigned.map((keys) =>
        texts.reduce((sum, text, i) => sum + (keys.includes(keyText(text)) ? costs[i] : 0), 0),
      );
      for (const [i, load] of loads.entries()) expect(load).toBeCloseTo(expected[i], 6);
      const total = costs.reduce((sum, ms) => sum + ms, 0);
      const sorted = [...costs].sort((a, b) => b - a);
      // no schedule is faster than any of these
      const least = Math.max(total / shards, sorted[0], (sorted[shards - 1] ?? 0) + (sorted[shards] ?? 0));
      expect(Math.max(...loads)).toBeLessThanOrEqual((4 / 3) * least + 1e-9);
    }),
  );
});

it('counts levels without a known cost as the mean, and levels of the same bytes once for a shard', async () => {
  const texts = ['a', 'b', 'b', 'c'];
  const { assigned, expected, known } = await balance(entries(texts), costsOf([3, 1]), 2);
  expect(known).toBe(2);
  expect(expected.reduce((sum, ms) => sum + ms, 0)).toBe(3 + 1 + 2 + 2);
  expect(assigned.flat().filter((key) => key === keyText('b'))).toHaveLength(1);
});

itDeep('assigns no more levels than a plan may have, those that cost most, and leaves the others to the rule', async () => {
  const count = MOST_ASSIGNED + 50;
  const texts = Array.from({ length: count }, (_, i) => `level ${i}`);
  // 20 long ones; of the others, which cost the same, some are assigned
  const costs = texts.map((_, i) => (i % 3000 === 7 ? 1000 + i : 1));
  const { assigned, expected } = await balance(entries(texts), costsOf(costs), 4);
  const keys = new Set(assigned.flat());
  expect(keys.size).toBe(MOST_ASSIGNED);
  for (const [i, text] of texts.entries()) if (costs[i] > 1) expect(keys).toContain(keyText(text));
  expect(expected.reduce((sum, ms) => sum + ms, 0)).toBeCloseTo(
    costs.reduce((sum, ms) => sum + ms, 0),
    3,
  );
});

it('a table of numbers has what a Map has', () => {
  const key = fc.oneof(fc.nat(50), fc.nat(2 ** 30), fc.constantFrom(1024, 2048, 2 ** 47));
  fc.assert(
    fc.property(fc.array(fc.tuple(key, fc.double({ noNaN: true })), { maxLength: 2000, size: 'max' }), (pairs) => {
      const table = new NumberTable();
      for (const [at, value] of pairs) table.set(at, value);
      const map = new Map(pairs);
      expect(table.size).toBe(map.size);
      expect(new Map(table.entries())).toEqual(map);
      for (const [at, value] of map) expect(table.get(at)).toBe(value);
      expect(table.get(51)).toBe(map.get(51));
    }),
  );
});

itQuick('gq plan --costs takes results and reports, and the merged report stays the same', async () => {
  const set = await makeSet(levelTexts(30));
  try {
    await planSet(set, 2);
    for (const shard of [0, 1]) expect((await runShard(set, shard)).code).toBe(0);
    const before = await merge(set, '--format', 'json');
    // costs that differ a thousandfold
    mkdirSync(join(set.directory, 'costs'));
    for (const shard of [0, 1]) {
      const lines = resultLines(set, shard).map((line) =>
        line.replace(
          /"n":(\d+),(.*?)"ms":[-+.e\d]+,"result"/,
          (_, n, head) => `"n":${n},${head}"ms":${Number(n) % 10 === 0 ? 1000 + Number(n) : 1},"result"`,
        ),
      );
      writeFileSync(join(set.directory, 'costs', `shard-${shard}.ndjson`), lines.map((line) => `${line}\n`).join(''));
    }
    const planned = await gq(['plan', ...set.paths, '--shards', '3', '--force', '--costs', 'costs'], { cwd: set.directory });
    expect(planned.stderr).toMatch(
      /by what 30 of them have cost, the slowest shard takes 1\.0 s in one thread, \d\.\d % more than the mean/,
    );
    const plan = JSON.parse(readFileSync(join(set.directory, 'plan.json'), 'utf8'));
    // one long level for each of the three
    for (const { assigned } of plan.shards) {
      const long = [0, 10, 20].filter((n) => assigned.includes(keyText(set.texts[n])));
      expect(long).toHaveLength(1);
    }
    rmSync(join(set.directory, 'out'), { recursive: true });
    for (const shard of [2, 0, 1]) expect((await runShard(set, shard)).code).toBe(0);
    const after = await merge(set, '--format', 'json');
    expect(after.stdout).toBe(before.stdout);
    // the times of a report
    const direct = await gq(['check', ...set.paths, '--reporter', 'json=report.json'], { cwd: set.directory });
    expect(direct.code).toBe(1);
    const again = await gq(['plan', ...set.paths, '--shards', '3', '--force', '--costs', 'report.json'], { cwd: set.directory });
    expect(again.stderr).toContain('by what 30 of them have cost');
    // a merged report has none
    writeFileSync(join(set.directory, 'merged.json'), after.stdout);
    const none = await gq(['plan', ...set.paths, '--shards', '3', '--force', '--costs', 'merged.json'], { cwd: set.directory });
    expect(none).toMatchObject({ code: 2 });
    expect(none.stderr).toContain('it has no times');
  } finally {
    set.remove();
  }
});

it.each(['-5', '1e400', '1e300'])('gq plan refuses a cost of %s ms, wherever it is', async (ms) => {
  const set = await makeSet(levelTexts(3));
  try {
    const file = 'levels/0000.level.json';
    writeFileSync(join(set.directory, 'report.json'), `{"levels": [{"file": "${file}", "ms": ${ms}}]}`);
    mkdirSync(join(set.directory, 'results'));
    const record = `{"n":0,"file":"${file}","sha256":"${'0'.repeat(64)}","ms":${ms},"result":{}}\n`;
    writeFileSync(join(set.directory, 'results/shard-0.ndjson'), record);
    for (const [costs, where] of [
      ['report.json', 'report.json'],
      ['results', 'results/shard-0.ndjson'],
    ]) {
      const { code, stderr } = await gq(['plan', ...set.paths, '--shards', '2', '--costs', costs], { cwd: set.directory });
      expect(code).toBe(2);
      expect(stderr).toContain(`--costs ${where}: expected times from 0 to 30000000000 ms, found ${Number(ms)} for ${file}`);
    }
  } finally {
    set.remove();
  }
});
