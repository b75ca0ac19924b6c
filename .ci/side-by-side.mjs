import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { constants } from 'node:os';
import { setTimeout } from 'node:timers/promises';

// node .ci/side-by-side.mjs AT_ONCE < STEPS
// Runs steps, one a line, `name: command of bash`, at most so many at once, in their order. What a step prints is kept and
// printed whole when it ends. When a step fails, the others go on, as they may tell more; what failed is printed last, and the
// first failure decides the exit code. A signal ends all.

/** ms that a step has to end by itself, as browsers must to leave nothing behind */
const PATIENCE = 10_000;

/** ms that the last output of a step has to arrive */
const LAST_WORDS = 1000;

const atOnce = Number(process.argv[2]);
const waiting = readFileSync(0, 'utf8')
  .split('\n')
  .filter((line) => line.trim() !== '')
  .map((line) => {
    const [, name, command] = /^\s*([^:]+): (.+)$/.exec(line) ?? [];
    if (name === undefined) throw new Error(`expected a line "name: command", found: ${line}`);
    return { name, command };
  });
if (!(atOnce >= 1) || waiting.length === 0) throw new Error('expected a number of steps at once, and steps');

/** The steps that run, by their process. */
const running = new Map();
/** Names of the steps that failed. */
const failed = [];
/** Name of the signal that ended all. */
let reason = null;
let exitCode = 0;

const seconds = (since) => `${((performance.now() - since) / 1000).toFixed(0)} s`;

const show = (name, how, output) => process.stdout.write(`\n== ${name}: ${how}\n${output}`);

/** Asks a step with all its processes to end, and ends it if it does not. */
async function end(child) {
  const send = (signal) => {
    try {
      process.kill(-child.pid, signal);
    } catch {
      // it has ended
    }
  };
  send('SIGTERM');
  await setTimeout(PATIENCE, undefined, { ref: false });
  send('SIGKILL');
}

function endAll(signal) {
  if (reason !== null) return;
  reason = signal;
  exitCode = 128 + constants.signals[signal];
  waiting.length = 0;
  for (const child of running.keys()) void end(child);
}

for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, endAll);

/** Runs a step to its end. @returns what to print last, if it failed */
function run({ name, command }) {
  return new Promise((resolve) => {
    const began = performance.now();
    // a group of its own, so that it can be ended with all its processes
    const child = spawn('bash', ['-euo', 'pipefail', '-c', command], { detached: true, stdio: ['ignore', 'pipe', 'pipe'] });
    running.set(child, name);
    const pieces = [];
    for (const stream of [child.stdout, child.stderr]) stream.on('data', (piece) => pieces.push(piece));
    child.on('exit', async (code, signal) => {
      // what it has left running may still hold its streams
      await Promise.race([once(child, 'close'), setTimeout(LAST_WORDS, undefined, { ref: false })]);
      running.delete(child);
      const output = Buffer.concat(pieces).toString();
      const took = seconds(began);
      if (reason !== null) show(name, `ended after ${took}, because of ${reason}`, output);
      else if (code === 0) show(name, `passed in ${took}`, output);
      else {
        failed.push(name);
        exitCode ||= code ?? 128 + constants.signals[signal];
        resolve(() => show(name, `FAILED after ${took} with ${code ?? signal}`, output));
        return;
      }
      resolve(null);
    });
  });
}

const began = performance.now();
const last = [];
const lane = async () => {
  for (let step = waiting.shift(); step !== undefined; step = waiting.shift()) last.push(await run(step));
};
await Promise.all(Array.from({ length: atOnce }, lane));
for (const print of last) print?.();
const how = failed.length === 0 ? 'all passed' : `failed: ${failed.join(', ')}`;
console.log(`\n${reason === null ? how : `ended by ${reason}`} in ${seconds(began)}`);
process.exitCode = exitCode;
