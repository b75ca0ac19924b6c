import { constants } from 'node:os';
import process from 'node:process';
import { setImmediate } from 'node:timers/promises';

// A signal that nobody catches ends a process at once, whatever it is at, and a shell reports 130 or 143. That is the rule here, since a
// handler of ours is called only when the event loop comes round: never during long work, nor while a write waits for its reader.
// Signals are caught only where they must not cut something in two, and where the loop is free. The way back is the danger: a signal that
// was caught, and whose handler is taken away before the loop has called it, is lost. So the loop goes round first (`hearSignals`).

const SIGNALS = ['SIGINT', 'SIGTERM'] as const;

/** Windows has no such exit codes, and process 1 (of a container) is not ended by what it doesn't catch: they always catch. */
const ALWAYS_CATCHES = process.platform === 'win32' || process.pid === 1;

let isCatching = false;
let undo: () => void = () => {};

const end = (signal: NodeJS.Signals): void => {
  try {
    undo();
  } finally {
    process.exit(128 + constants.signals[signal]);
  }
};

/**
 * From now on the event loop ends the process, workers and all, with 130 on SIGINT and 143 on SIGTERM. For work that leaves the loop free:
 * the rest is to be done before, or behind `leaveSignals`.
 */
export function catchSignals(): void {
  if (isCatching) return;
  isCatching = true;
  for (const signal of SIGNALS) process.on(signal, end);
}

/** Ends the process when a signal has been caught by now; does nothing where none is caught. */
export async function hearSignals(): Promise<void> {
  if (!isCatching) return;
  // the first turn may begin behind the place where the loop looks
  await setImmediate();
  await setImmediate();
}

/** Ends the process when a signal has been caught by now, and leaves later ones to the system. */
export async function leaveSignals(): Promise<void> {
  await hearSignals();
  if (!isCatching || ALWAYS_CATCHES) return;
  isCatching = false;
  for (const signal of SIGNALS) process.off(signal, end);
}

/** At the start of the process. */
export function beginSignals(): void {
  if (ALWAYS_CATCHES) catchSignals();
}

/**
 * Does short synchronous work that no signal is to cut in two, such as writing a file. One that came before ends the process before
 * it, one that comes meanwhile right after it.
 */
export async function uncut<T>(work: () => T): Promise<T> {
  catchSignals();
  await hearSignals();
  try {
    return work();
  } finally {
    await hearSignals();
  }
}

/**
 * Does several short steps, all or none.
 * @param takeBack undoes the steps that were done, when a signal comes before the last, or one of them throws
 */
export async function allOrNone(steps: Iterable<() => void>, takeBack: () => void): Promise<void> {
  catchSignals();
  await hearSignals();
  undo = takeBack;
  try {
    for (const step of steps) {
      step();
      await hearSignals();
    }
  } catch (error) {
    takeBack();
    throw error;
  } finally {
    undo = () => {};
  }
}
