import process from 'node:process';

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
