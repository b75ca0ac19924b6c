// A process that runs one command of gq after another, for tests/cli/gq.ts: only the first pays for starting node and loading gq.
import { closeSync, createReadStream, mkdtempSync, openSync, rmSync, writeFileSync, writeSync } from 'node:fs';
import { register, syncBuiltinESMExports } from 'node:module';
import os from 'node:os';
import { join } from 'node:path';
import process from 'node:process';
import { runCommandLine } from '../../dist/gq/command-line.js';

register(new URL('./thread-hooks.mjs', import.meta.url).href);
// what a command does by default must not depend on the machine
os.availableParallelism = () => 1;
syncBuiltinESMExports();

/** @typedef {{ code: number, signal: null, stdout: string, stderr: string }} Ended */

let pieces = [];

/** Keeps what is written to a stream. */
function collect(stream) {
  stream.write = (piece, encoding, done) => {
    pieces.push({ stream, bytes: Buffer.from(piece) });
    const callback = typeof encoding === 'function' ? encoding : done;
    if (callback) process.nextTick(callback);
    return true;
  };
}

for (const stream of [process.stdout, process.stderr]) collect(stream);

/** What was written to a stream, or to both in their order. */
const written = (only) =>
  Buffer.concat(pieces.flatMap(({ stream, bytes }) => (only === undefined || stream === only ? [bytes] : []))).toString();

/** Makes a file the standard input. */
function takeInput(path) {
  // what is opened next gets the lowest number that is free
  closeSync(0);
  if (openSync(path) !== 0) throw new Error(`${path} is not the standard input`);
}

// Node makes the stream of the standard input once, and a command reads it to its end: each gets one of its own
let input = null;
Object.defineProperty(process, 'stdin', {
  get: () => (input ??= Object.assign(createReadStream('', { fd: 0, autoClose: false }), { isTTY: undefined })),
});

/** Calls a function with a standard input; null: an empty one. */
async function withInput(content, call) {
  input = null;
  if (content === null) return call();
  const folder = mkdtempSync(join(os.tmpdir(), 'gq-input-'));
  try {
    writeFileSync(join(folder, 'input'), Buffer.from(content, 'base64'));
    takeInput(join(folder, 'input'));
    return await call();
  } finally {
    takeInput(os.devNull);
    rmSync(folder, { recursive: true });
  }
}

/** @returns {Promise<{ ended: Ended, shown: string }>} `shown`: both streams, as a terminal shows them */
async function run({ args, cwd, env, input }) {
  process.chdir(cwd);
  process.exitCode = undefined;
  const usual = { ...process.env };
  Object.assign(process.env, env);
  const code = await withInput(input, () => runCommandLine(args));
  for (const name of Object.keys(env)) {
    if (name in usual) process.env[name] = usual[name];
    else delete process.env[name];
  }
  // the command line expects to be called once in a process
  process.stdout.removeAllListeners('error');
  process.stderr.removeAllListeners('error');
  process.removeAllListeners('uncaughtException');
  const ended = { code, signal: null, stdout: written(process.stdout), stderr: written(process.stderr) };
  const shown = written();
  pieces = [];
  return { ended, shown };
}

// one at a time: the working directory and the streams belong to the whole process
let last = Promise.resolve();
process.on('message', ({ id, ...command }) => {
  last = last.then(async () => void process.send({ id, ...(await run(command)) }));
});
// a command that ends the process, as a crash does, is not to hide what it said
process.on('exit', () => void writeSync(2, written()));
