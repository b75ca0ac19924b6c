import { spawnSync } from 'node:child_process';
import { readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { MAIN } from '../cli/gq.ts';
import { declareMissing } from '../missing.ts';
import { levelTexts, makeSet, type TestSet } from './sets.ts';

const SCRIPT = fileURLToPath(new URL('../../templates/fleet/gnu-parallel.sh', import.meta.url));
const isThere = spawnSync('parallel', ['--version'], { encoding: 'utf8' }).stdout?.startsWith('GNU parallel') ?? false;

if (!isThere) declareMissing('gq with GNU parallel', 'GNU parallel is needed (apt-get install parallel)');
else {
  describe('the script for GNU parallel', () => {
    let set: TestSet;
    beforeAll(async () => {
      set = await makeSet(levelTexts(12));
    });
    afterAll(() => set.remove());

    const script = (...args: readonly string[]) =>
      spawnSync(SCRIPT, args, {
        cwd: set.directory,
        encoding: 'utf8',
        env: { ...process.env, GQ: MAIN, JOBS: '2' },
      });
    const results = () => readdirSync(join(set.directory, 'run/out')).sort();

    it('does all shards, and later those that are missing', () => {
      const first = script('run', '4', ...set.paths);
      expect(first.stderr).toContain('4 shards, 12 levels: each exactly once');
      const all = results();
      expect(all).toHaveLength(4);
      for (const name of ['shard-0.ndjson', 'shard-3.ndjson']) rmSync(join(set.directory, 'run/out', name));
      const second = script('run');
      expect(second.stderr.match(/written/g)).toHaveLength(2);
      expect([second.status, second.stdout]).toEqual([first.status, first.stdout]);
      expect(results()).toEqual(all);
      const third = script('run');
      expect(third.stderr).not.toContain('written');
      expect([third.status, third.stdout]).toEqual([first.status, first.stdout]);
    });

    it('goes on with the plan that it is asked for, and with no other', () => {
      const again = script('run', '4', ...set.paths);
      expect(again.stderr).toContain('4 shards, 12 levels: each exactly once');
      const before = results();
      const other = script('run', '5', ...set.paths);
      expect(other).toMatchObject({ status: 2, stdout: '' });
      expect(other.stderr).toContain('run/plan.json: another file is there, and nothing was overwritten');
      expect(results()).toEqual(before);
    });

    it('ends as the merge does when that refuses the results', () => {
      writeFileSync(join(set.directory, 'run/out/shard-3.ndjson'), 'something else\n');
      const { status, stdout, stderr } = script('run');
      expect({ status, stdout }).toEqual({ status: 2, stdout: '' });
      expect(stderr).toContain('run/out/shard-3.ndjson: it does not begin as a result of a shard');
    });

    it('says what it expects', () => {
      expect(script('none')).toMatchObject({ status: 1, stderr: expect.stringContaining('expected the number of shards') });
      const nothing = script('none', '4', 'nothing.ndjson');
      expect(nothing.status).toBe(2);
      expect(nothing.stderr).toContain('nothing.ndjson');
    });
  });
}
