import { spawnSync } from 'node:child_process';

const FOLDERS = [
  'engine',
  'solver',
  'hard-cases',
  'schema',
  'render',
  'truth',
  'browsers',
  'check',
  'editor',
  'cli',
  'server',
].map((name) => `tests/${name}`);

/** The deep set tries few examples of each property, so that it does not take long. */
const TIMES = 10;

/**
 * Tries the properties of the tests on ten times as many examples, with one seed after the other. Sets the exit code to 1 if a
 * test fails; what it prints names the seed.
 * @param from - the first seed, for `PROPERTY_SEED`
 * @param until - when to stop, ms since 1970
 */
export function attackProperties(from: number, until: number): void {
  let seed = from;
  for (; Date.now() < until; seed++) {
    const ended = spawnSync(
      process.execPath,
      ['node_modules/vitest/vitest.mjs', 'run', '--mode', 'built', '--project', 'deep', ...FOLDERS],
      {
        env: { ...process.env, PROPERTY_SEED: String(seed), PROPERTY_RUNS: String(TIMES) },
        stdio: 'inherit',
        timeout: until - Date.now(),
      },
    );
    if (ended.signal !== null) break;
    if (ended.status !== 0) {
      console.log(`bug  properties with PROPERTY_SEED=${seed} PROPERTY_RUNS=${TIMES}`);
      process.exitCode = 1;
    }
  }
  console.log(`\n${seed - from} seeds (from ${from}) tried to the end`);
}
