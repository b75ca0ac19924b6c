import process from 'node:process';

const WAIT = 500;
const CLEAR = '\r\u001b[2K';

export interface StatusLine {
  /** Shows a text in place of the last one. */
  show(text: string): void;
  /** Takes the line away. */
  clear(): void;
}

/** One line on stderr when that is a terminal and the work takes over half a second; nothing otherwise. */
export function createStatusLine(): StatusLine {
  if (!process.stderr.isTTY) return { show: () => {}, clear: () => {} };
  const start = performance.now();
  let shown = false;
  return {
    show(text) {
      if (performance.now() - start < WAIT) return;
      shown = true;
      // a line that wraps could not be taken away
      process.stderr.write(CLEAR + text.slice(0, (process.stderr.columns || 80) - 1));
    },
    clear() {
      if (shown) process.stderr.write(CLEAR);
      shown = false;
    },
  };
}

export interface Progress {
  /** Shows how far the work is. */
  update(done: number): void;
  /** Takes the line away. */
  clear(): void;
}

/** Says how many of `total` are done. */
export function createProgress(what: string, total: number): Progress {
  const line = createStatusLine();
  return { update: (done) => line.show(`${what}: ${done} of ${total}`), clear: line.clear };
}
