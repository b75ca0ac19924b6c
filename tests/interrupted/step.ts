import { existsSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** Where a program is interrupted, and what happens to it there. */
export interface Interruption {
  /**
   * Which steps count: `file` (calls of `node:fs`), `change` (those that may change the disk), `thread` (messages to and from worker threads, their start and end), `output`
   * (writes to stdout and stderr), `signal` (handlers that are added and removed), or one function of `node:fs` or event by its
   * name. Every step when left out. Only the main thread is looked at.
   */
  readonly of?: string;
  /** The first is 1; the program is not interrupted when it has fewer, or with 0. */
  readonly number: number;
  /** Steps count only after the first of this kind. */
  readonly after?: string;
  /** Sent to the program by itself, right before the step. */
  readonly signals?: readonly NodeJS.Signals[];
  /** A folder, copied before the signals are sent. */
  readonly copy?: { readonly from: string; readonly to: string };
  /** A file, written at the step. */
  readonly write?: { readonly path: string; readonly text: string };
  /** Said on stderr at the step. */
  readonly say?: string;
  /** A file in which the number of steps is left when the program ends by itself. */
  readonly count?: string;
}

/** The environment in which a program of Node is interrupted. */
export function interruptAt(interruption: Interruption): Readonly<Record<string, string>> {
  const preload = pathToFileURL(join(projectFolder(), 'tests/interrupted/preload.mjs'));
  return { NODE_OPTIONS: `--import=${preload}`, GQ_INTERRUPT: JSON.stringify(interruption) };
}

/** The folder of the project, from the source and from what is compiled into dist/. */
export function projectFolder(): string {
  let folder = dirname(fileURLToPath(import.meta.url));
  while (!existsSync(join(folder, 'package.json'))) folder = dirname(folder);
  return folder;
}
