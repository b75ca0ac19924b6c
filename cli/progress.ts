import process from 'node:process';

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
