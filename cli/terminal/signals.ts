import { constants } from 'node:os';
import process from 'node:process';
import { setImmediate, setTimeout } from 'node:timers/promises';

// A signal without a handler ends the process at once, and a shell reports 130 or 143. That is the default here: the event loop
// calls a handler only when it is free, not during long work, nor while a write waits for its reader. Signals are caught only
// during work that they must not interrupt, and while the loop is free. Removing a handler is risky: a signal that was caught
// is lost if its handler is removed before the loop has called it. So the loop runs first (`hearSignals`).

const SIGNALS = ['SIGINT', 'SIGTERM'] as const;

/** Windows has no such exit codes, and a signal without a handler doesn't end process 1 (of a container): both always catch. */
const ALWAYS_CATCHES = process.platform === 'win32' || process.pid === 1;

let isCatching = false;
/** What is taken back before a signal ends the process, the latest first. */
const undos: (() => void)[] = [];

/** Takes a signal that is not to end the process; null: every signal ends it. */
let listener: ((signal: NodeJS.Signals) => boolean) | null = null;

const end = (signal: NodeJS.Signals): void => {
  if (listener?.(signal)) return;
  try {
    for (const undo of undos.reverse()) undo();
  } finally {
    process.exit(128 + constants.signals[signal]);
  }
};

/**
 * From now on a signal ends the process and its workers through the event loop: with 130 on SIGINT and 143 on SIGTERM. This is
 * for work that leaves the loop free; other work belongs before this call, or after `leaveSignals`.
 */
export function catchSignals(): void {
  if (isCatching) return;
  isCatching = true;
  for (const signal of SIGNALS) process.on(signal, end);
}

/** Ends the process if a signal has been caught; does nothing while signals are not caught. */
export async function hearSignals(): Promise<void> {
  if (!isCatching) return;
  // the first turn may begin after the loop has already looked for signals
  await setImmediate();
  await setImmediate();
}

/** Ends the process if a signal has been caught, and leaves later ones to the system. */
export async function leaveSignals(): Promise<void> {
  await hearSignals();
  if (!isCatching || ALWAYS_CATCHES) return;
  isCatching = false;
  for (const signal of SIGNALS) process.off(signal, end);
}

/** Called at the start of the process. */
export function beginSignals(): void {
  if (ALWAYS_CATCHES) catchSignals();
}

/**
 * Does short synchronous work that no signal may interrupt, such as writing a file. An earlier signal ends the process before
 * the work, and a signal during the work ends it right afterwards.
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
 * Does several short steps: all or none.
 * @param takeBack undoes the steps that were done, if a signal comes before the last one or a step throws
 */
export async function allOrNone(steps: Iterable<() => void>, takeBack: () => void): Promise<void> {
  await withUndo(takeBack, async () => {
    try {
      for (const step of steps) {
        step();
        await hearSignals();
      }
    } catch (error) {
      takeBack();
      throw error;
    }
  });
}

/**
 * From now on a signal ends the process through the event loop, and calls a function before.
 * @returns ends that
 */
export function onSignal(takeBack: () => void): () => void {
  catchSignals();
  undos.push(takeBack);
  return () => {
    const at = undos.lastIndexOf(takeBack);
    if (at >= 0) undos.splice(at, 1);
  };
}

/** Does work that is taken back if a signal ends the process in it. */
export async function withUndo<T>(takeBack: () => void, work: () => Promise<T>): Promise<T> {
  catchSignals();
  await hearSignals();
  const forget = onSignal(takeBack);
  try {
    return await work();
  } finally {
    forget();
  }
}

/** The exit code after a signal. */
export const exitCodeAfter = (signal: StoppingSignal): 130 | 143 => (signal === 'SIGINT' ? 130 : 143);

export type StoppingSignal = (typeof SIGNALS)[number];

/**
 * ms in which the same signal again is taken for the same one: on Ctrl-C the terminal sends it to every process, and npx passes
 * it on once more
 */
const REPEATED = 200;

/**
 * Does long work that leaves the event loop free, and that the first signal only stops: the caller then reports what is done and
 * ends with `exitCodeAfter`. A second signal ends the process at once.
 * @param work stops early, with what is done, when it is told to
 * @returns the signal that came; null if none did
 */
export async function stoppable<T>(
  work: (stopping: AbortSignal) => Promise<T>,
): Promise<{ readonly done: T; readonly signal: StoppingSignal | null }> {
  const stopping = new AbortController();
  let first: { readonly signal: StoppingSignal; readonly at: number } | null = null;
  catchSignals();
  listener = (signal) => {
    if (first !== null) return signal === first.signal && performance.now() - first.at < REPEATED;
    first = { signal: signal as StoppingSignal, at: performance.now() };
    stopping.abort();
    return true;
  };
  try {
    const done = await work(stopping.signal);
    await hearSignals();
    const heard = first as { readonly signal: StoppingSignal; readonly at: number } | null;
    if (heard !== null) await setTimeout(Math.max(0, heard.at + REPEATED - performance.now()));
    return { done, signal: heard?.signal ?? null };
  } finally {
    listener = null;
  }
}
