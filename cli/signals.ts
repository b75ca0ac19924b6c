import { constants } from 'node:os';
import process from 'node:process';

const SIGNALS = ['SIGINT', 'SIGTERM'] as const;

const end = (signal: NodeJS.Signals): void => process.exit(128 + constants.signals[signal]);

/** Ends the process, workers and all, with 130 on SIGINT and 143 on SIGTERM. */
export function endOnSignals(): void {
  for (const signal of SIGNALS) process.on(signal, end);
}

/**
 * Does work that may take long without ever coming back to the event loop. Meanwhile signals are left to the system, which
 * ends the process at once (a shell reports 130 and 143 then, too): a handler of ours would not be called until the end.
 */
export function endAtOnceDuring<T>(work: () => T): T {
  for (const signal of SIGNALS) process.off(signal, end);
  try {
    return work();
  } finally {
    for (const signal of SIGNALS) process.on(signal, end);
  }
}

/** The exit code of a process that such a signal ended. */
export type SignalCode = 130 | 143;

/**
 * Does work that a signal is to bring to a good end: the first one calls `stop`, with the exit code that belongs to it; a
 * second one ends the process as ever.
 */
export async function stopOnSignalDuring<T>(stop: (code: SignalCode) => void, work: () => Promise<T>): Promise<T> {
  const heard = (signal: NodeJS.Signals): void => {
    giveBack();
    stop(signal === 'SIGINT' ? 130 : 143);
  };
  const giveBack = (): void => {
    for (const signal of SIGNALS) {
      process.off(signal, heard);
      process.off(signal, end);
      process.on(signal, end);
    }
  };
  for (const signal of SIGNALS) {
    process.off(signal, end);
    process.on(signal, heard);
  }
  try {
    return await work();
  } finally {
    giveBack();
  }
}
