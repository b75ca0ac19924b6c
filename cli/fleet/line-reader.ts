import { closeSync, readSync } from 'node:fs';
import { openRegularFile } from '../io/index.ts';

const NEWLINE = 0x0a;

/** Bytes of a line at most; no record is as long. */
const LONGEST = 64 * 1024 * 1024;

/**
 * Reads a file line by line, however long it is. The file is open only while a piece is read, so that any number of files can be
 * read side by side.
 */
export class LineReader {
  private rest: Buffer = Buffer.alloc(0);
  private from = 0;
  private position = 0;
  private isAtEnd = false;

  /** @param piece bytes that are read at a time */
  constructor(
    private readonly path: string,
    private readonly piece = 256 * 1024,
  ) {}

  /**
   * The bytes of the next line without its end, valid until the next call; null at the end of the file. A last line without an end
   * is no line.
   * @throws NotAFile, and system errors
   */
  next(): Buffer | null {
    for (;;) {
      const end = this.rest.indexOf(NEWLINE, this.from);
      if (end >= 0) {
        const line = this.rest.subarray(this.from, end);
        this.from = end + 1;
        return line;
      }
      if (this.isAtEnd || this.rest.length - this.from > LONGEST) return null;
      this.fill();
    }
  }

  /** The bytes that follow the last line. */
  get unended(): Buffer {
    return this.rest.subarray(this.from);
  }

  private fill(): void {
    const kept = this.rest.length - this.from;
    // doubles with the length of a line, so that a long one is not copied again and again
    const next = Buffer.allocUnsafe(kept + Math.max(this.piece, kept));
    this.rest.copy(next, 0, this.from);
    const descriptor = openRegularFile(this.path);
    try {
      const count = readSync(descriptor, next, kept, next.length - kept, this.position);
      this.position += count;
      this.isAtEnd = count === 0;
      this.rest = next.subarray(0, kept + count);
      this.from = 0;
    } finally {
      closeSync(descriptor);
    }
  }
}
