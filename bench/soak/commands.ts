import { spawnSync } from 'node:child_process';
import { killWriterAt } from '../../tests/interrupted/killed-writer.ts';
import { runWhole, SIGNALLED_COMMANDS, signalAt } from '../../tests/interrupted/signalled-command.ts';
import { PROJECT } from '../harness/index.ts';
import { type Attacked, type Span, seedsOf } from './span.ts';

/** Sends signals to commands before each of their steps, command after command, each for an equal share of the time. */
export async function attackSignals({ from, most, until }: Span): Promise<Attacked> {
  let [tried, bugs] = [0, 0];
  const told: string[] = [];
  const commands = Object.entries(SIGNALLED_COMMANDS);
  for (const [i, [name, command]] of commands.entries()) {
    const share = Date.now() + (until - Date.now()) / (commands.length - i);
    const whole = await runWhole(command);
    let last = from;
    for (const step of seedsOf({ from, most: Math.min(most, whole.steps - from), until: share })) {
      last = 1 + step;
      for (const signals of [['SIGINT'], ['SIGTERM'], ['SIGTERM', 'SIGINT', 'SIGTERM']] as const) {
        const wrong = await signalAt(whole, 1 + step, signals);
        if (wrong === null) continue;
        tried++;
        if (wrong.length > 0) bugs++;
        for (const what of wrong) console.log(`bug  ${name}, step ${1 + step}, ${signals.join()}: ${what}`);
      }
    }
    told.push(`${name}: steps ${1 + from} to ${last} of ${whole.steps}`);
  }
  return { tried, bugs, told: told.join('; ') };
}

/** Kills a program that changes a folder of levels before each of its steps: a file that is not whole or lost is a bug. */
export async function attackWriters(span: Span): Promise<Attacked> {
  let [tried, bugs] = [0, 0];
  for (const step of seedsOf(span)) {
    tried++;
    const { steps, wrong } = await killWriterAt(1 + step);
    if (wrong.length > 0) bugs++;
    for (const what of wrong) console.log(`bug  step ${1 + step}: ${what}`);
    if (steps !== null) break;
  }
  return { tried, bugs, told: `writers killed at steps ${1 + span.from} to ${span.from + tried}` };
}

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

/** Tries the properties of the tests on ten times as many examples, with one seed after the other. What a test that fails prints names the seed. */
export function attackProperties({ from, until }: Span): Attacked {
  let [tried, bugs] = [0, 0];
  for (const seed of seedsOf({ from, most: Number.POSITIVE_INFINITY, until })) {
    const ended = spawnSync(
      process.execPath,
      ['node_modules/vitest/vitest.mjs', 'run', '--mode', 'built', '--project', 'deep', ...FOLDERS],
      {
        cwd: PROJECT,
        env: { ...process.env, PROPERTY_SEED: String(seed), PROPERTY_RUNS: String(TIMES) },
        stdio: 'inherit',
        timeout: until - Date.now(),
      },
    );
    // out of time; the program may have answered the signal with an exit code of its own
    if (ended.signal !== null || ended.error !== undefined) break;
    tried++;
    if (ended.status === 0) continue;
    bugs++;
    console.log(`bug  properties with PROPERTY_SEED=${seed} PROPERTY_RUNS=${TIMES}`);
  }
  return { tried, bugs, told: `${tried} seeds from ${from} on tried to the end` };
}
