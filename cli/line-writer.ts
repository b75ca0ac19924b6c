import { randomBytes } from 'node:crypto';
import { closeSync, fsyncSync, openSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** Characters that are written at once. */
const PIECE = 256 * 1024;

/**
 * Writes a file beside its place, piece by piece, and moves it there at the end. Until then nothing is at its place.
 * All methods throw system errors; `discard` doesn't.
 */
export class LineWriter {
  readonly unfinished: string;
  private readonly descriptor: number;
  private waiting = '';
  private isOpen = true;

  constructor(path: string) {
    this.unfinished = join(dirname(path), `.gq-edit-${randomBytes(8).toString('hex')}.tmp`);
    this.descriptor = openSync(this.unfinished, 'wx', 0o666);
  }

  write(text: string): void {
    this.waiting += text;
    if (this.waiting.length >= PIECE) this.flush();
  }

  /** Syncs and closes the file. */
  end(): void {
    this.flush();
    fsyncSync(this.descriptor);
    this.close();
  }

  /** Removes the unfinished file, if it is still there. */
  discard(): void {
    this.close();
    rmSync(this.unfinished, { force: true });
  }

  private flush(): void {
    // writes everything or throws; a single writeSync may write less if the disk is nearly full
    writeFileSync(this.descriptor, this.waiting);
    this.waiting = '';
  }

  private close(): void {
    if (this.isOpen) closeSync(this.descriptor);
    this.isOpen = false;
  }
}
