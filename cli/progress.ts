import process from 'node:process';

const WAIT = 500;
const CLEAR = '\r\u001b[2K';

export interface Progress {
  /** Shows how far the work is. */
  update(done: number): void;
  /** Takes the line away. */
  clear(): void;
}

/** One line on stderr when that is a terminal and the work takes over half a second; nothing otherwise. */
export function createProgress(what: string, total: number): Progress {
  if (!process.stderr.isTTY) return { update: () => {}, clear: () => {} };
  const start = performance.now();
  let shown = false;
  return {
    update(done) {
      if (performance.now() - start < WAIT) return;
      shown = true;
      process.stderr.write(`${CLEAR}${what}: ${done} of ${total}`);
    },
    clear() {
      if (shown) process.stderr.write(CLEAR);
      shown = false;
    },
  };
}
