// A process that runs one command of gq after another, for tests/cli/gq.ts: only the first pays for starting node and loading gq.
import { writeSync } from 'node:fs';
import { register } from 'node:module';
import process from 'node:process';
import { runCommandLine } from '../../dist/cli/command-line.js';

const SHARED_POOLS = new URL('./shared-pools.mjs', import.meta.url).href;

// gq loads `tinypool` only when it needs threads
register(
  `data:text/javascript,${encodeURIComponent(`
  const shared = ${JSON.stringify(SHARED_POOLS)};
  export const resolve = (name, context, next) =>
    name === 'tinypool' && context.parentURL !== shared ? { url: shared, shortCircuit: true } : next(name, context);
`)}`,
);

/** @typedef {{ code: number, signal: null, stdout: string, stderr: string }} Ended */

/** Keeps what is written to a stream. */
function collect(stream) {
  let pieces = [];
  stream.write = (piece, encoding, done) => {
    pieces.push(typeof piece === 'string' ? Buffer.from(piece) : Buffer.from(piece));
    const callback = typeof encoding === 'function' ? encoding : done;
    if (callback) process.nextTick(callback);
    return true;
  };
  return () => {
    const text = Buffer.concat(pieces).toString();
    pieces = [];
    return text;
  };
}

const stdout = collect(process.stdout);
const stderr = collect(process.stderr);

/** @returns {Promise<Ended>} */
async function run(args, cwd) {
  process.chdir(cwd);
  process.exitCode = undefined;
  const code = await runCommandLine(args);
  // the command line expects to be called once in a process
  process.stdout.removeAllListeners('error');
  process.stderr.removeAllListeners('error');
  process.removeAllListeners('uncaughtException');
  return { code, signal: null, stdout: stdout(), stderr: stderr() };
}

// one at a time: the working directory and the streams belong to the whole process
let last = Promise.resolve();
process.on('message', ({ id, args, cwd }) => {
  last = last.then(async () => void process.send({ id, ended: await run(args, cwd) }));
});
// a command that ends the process, as a crash does, is not to hide what it said
process.on('exit', () => void writeSync(2, stdout() + stderr()));
