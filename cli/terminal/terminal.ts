import process from 'node:process';
import pc from 'picocolors';

export type Colors = ReturnType<typeof pc.createColors>;

/** No colours: for files, pipes and tests. */
export const PLAIN: Colors = pc.createColors(false);

/** Colours for a stream: used on a terminal, unless NO_COLOR is set or TERM is dumb, and always with FORCE_COLOR. */
export function colorsFor(stream: { readonly isTTY?: boolean }): Colors {
  const { NO_COLOR, FORCE_COLOR, TERM } = process.env;
  if (NO_COLOR) return PLAIN;
  return pc.createColors(FORCE_COLOR ? FORCE_COLOR !== '0' : stream.isTTY === true && TERM !== 'dumb');
}

/** The characters of a line of a terminal; null for files and pipes, which can have lines of any length. */
export function widthOf(stream: { readonly isTTY?: boolean; readonly columns?: number }): number | null {
  if (stream.isTTY !== true) return null;
  const asked = Number(process.env.COLUMNS);
  return Number.isInteger(asked) && asked > 0 ? asked : (stream.columns ?? null) || null;
}

const WAIT = 500;
const CLEAR = '\r\u001b[2K';

export interface StatusLine {
  /** Shows a text in place of the previous one. */
  show(text: string): void;
  /** Takes the line away. */
  clear(): void;
}

/** A status line on stderr, shown only on a terminal that can take it away, and after half a second of work. */
export function createStatusLine(): StatusLine {
  // a dumb terminal does not know the code that takes a line away
  if (!process.stderr.isTTY || process.env.TERM === 'dumb') return { show: () => {}, clear: () => {} };
  const start = performance.now();
  let shown = false;
  return {
    show(text) {
      if (performance.now() - start < WAIT) return;
      shown = true;
      // a wrapped line could not be cleared
      process.stderr.write(CLEAR + text.slice(0, (process.stderr.columns || 80) - 1));
    },
    clear() {
      if (shown) process.stderr.write(CLEAR);
      shown = false;
    },
  };
}

export interface Progress {
  /** Shows the number of items that are done. */
  update(done: number): void;
  /** Takes the line away. */
  clear(): void;
}

/** Shows how many of `total` items are done. */
export function createProgress(what: string, total: number): Progress {
  const line = createStatusLine();
  return { update: (done) => line.show(`${what}: ${done} of ${total}`), clear: line.clear };
}

/**
 * Writes to standard output and waits until there is room for more.
 * @returns whether anybody still reads it
 */
export async function print(text: string): Promise<boolean> {
  const { stdout } = process;
  if (stdout.destroyed || stdout.errored !== null) return false;
  if (stdout.write(text)) return true;
  await new Promise<void>((resolve) => {
    const done = (): void => {
      for (const event of ['drain', 'close', 'error']) stdout.off(event, done);
      resolve();
    };
    for (const event of ['drain', 'close', 'error']) stdout.on(event, done);
  });
  return !stdout.destroyed && stdout.errored === null;
}

/** Characters that are written at once. */
const PIECE = 64 * 1024;

/** Writes pieces to standard output until nobody reads them any more. */
export async function printAll(pieces: Iterable<string>): Promise<void> {
  let waiting = '';
  for (const piece of pieces) {
    waiting += piece;
    if (waiting.length < PIECE) continue;
    if (!(await print(waiting))) return;
    waiting = '';
  }
  await print(waiting);
}
