// Loaded before a program with `node --import`: counts what the program does, and interrupts it at one of its steps. So a test can
// interrupt a program anywhere, and at the same place each time: no clock takes part. `step.ts` documents the request.
import fs from 'node:fs';
import { syncBuiltinESMExports } from 'node:module';
import process from 'node:process';
import { isMainThread, MessagePort, Worker } from 'node:worker_threads';

const { of, number, after, signals = [], copy, write, say, count } = JSON.parse(process.env.GQ_INTERRUPT);
const { cpSync, writeFileSync, writeSync } = fs;

/** Functions that may change the disk. */
const CHANGES = /^(write|open|close|fsync|ftruncate|rename|link|rm|unlink|mkdir|fchmod|fchown)/;

let isCounting = after === undefined;
let left = number;
let steps = 0;
let isInterrupting = false;

function interrupt() {
  if (copy !== undefined) cpSync(copy.from, copy.to, { recursive: true });
  if (write !== undefined) writeFileSync(write.path, write.text);
  if (say !== undefined) writeSync(2, say);
  // the system delivers these before the call returns: a signal that nobody catches ends the program here
  for (const signal of signals) process.kill(process.pid, signal);
}

/** Called before each step; `names`: what it is called, the most general name last. */
function step(...names) {
  if (isInterrupting) return;
  if (!isCounting) {
    isCounting = names.includes(after);
    return;
  }
  if (of !== undefined && !names.includes(of)) return;
  steps++;
  if (--left !== 0) return;
  // what the interruption does itself is no step
  isInterrupting = true;
  interrupt();
  isInterrupting = false;
}

function countCalls(object, name, ...more) {
  const original = object[name];
  const counted = function (...args) {
    step(name, ...more);
    return original.apply(this, args);
  };
  object[name] = Object.assign(counted, original);
}

if (isMainThread) {
  for (const name of Object.keys(fs)) {
    if (!name.endsWith('Sync') || typeof fs[name] !== 'function') continue;
    countCalls(fs, name, ...(CHANGES.test(name) ? ['change'] : []), 'file');
  }
  syncBuiltinESMExports();
  // what goes to threads, and what comes back
  for (const { prototype } of [Worker, MessagePort]) countCalls(prototype, 'postMessage', 'thread');
  process.on('worker', (worker) => {
    for (const event of ['online', 'message', 'exit']) worker.on(event, () => step(event, 'thread'));
  });
  // what is said
  for (const stream of [process.stdout, process.stderr]) countCalls(stream, 'write', 'output');
  // signals that are caught, or no longer
  for (const event of ['newListener', 'removeListener']) {
    process.on(event, (name) => {
      if (name === 'SIGINT') step(event, 'signal');
    });
  }
  if (count !== undefined) process.on('exit', () => writeFileSync(count, String(steps)));
}
