/** The number with which a frame begins, and the last of the 16 with which one begins that readers skip. */
const FRAME = 0xfd2fb528;
const SKIPPED = 0x184d2a50;

/** Bytes of the length of the content and of the number of a dictionary, by their flags. */
const LENGTHS = [0, 2, 4, 8] as const;
const DICTIONARIES = [0, 1, 2, 4] as const;

/** A kind of block that is one byte, repeated. */
const REPEATED = 1;

/** Bytes that come next: `isKept`, if they decide on what follows. */
interface Next {
  readonly length: number;
  readonly isKept: boolean;
}

const kept = (length: number): Next => ({ length, isKept: true });
const passed = (length: number): Next => ({ length, isKept: false });

/** The parts of a frame, as RFC 8878 has them. Each yield gets the bytes that it has asked for, if they are kept. */
function* parts(): Generator<Next, void, Buffer> {
  const magic = (yield kept(4)).readUInt32LE();
  if ((magic & ~0xf) >>> 0 === SKIPPED) {
    yield passed((yield kept(4)).readUInt32LE());
    return;
  }
  if (magic !== FRAME) throw new Error('unknown frame descriptor');
  const descriptor = (yield kept(1))[0];
  const isSingle = (descriptor & 0x20) !== 0;
  const length = descriptor >>> 6 === 0 && isSingle ? 1 : LENGTHS[descriptor >>> 6];
  yield passed((isSingle ? 0 : 1) + DICTIONARIES[descriptor & 3] + length);
  for (let isLast = false; !isLast; ) {
    const block = (yield kept(3)).readUIntLE(0, 3);
    isLast = (block & 1) === 1;
    yield passed(((block >>> 1) & 3) === REPEATED ? 1 : block >>> 3);
  }
  if ((descriptor & 4) !== 0) yield passed(4);
}

/**
 * Says where a zstd frame ends, without unpacking it. Node unpacks the first frame of a file and leaves out others, and
 * some of its versions take a frame that is cut off for a whole one (seen with 22.15).
 */
export class ZstdFrame {
  private readonly parts = parts();
  private next: IteratorResult<Next, void> = this.parts.next();
  private left = 4;
  private bytes: number[] = [];

  get isWhole(): boolean {
    return this.next.done === true;
  }

  /** @returns how many bytes of the piece belong to the frame. @throws Error if it is none */
  take(piece: Uint8Array): number {
    let at = 0;
    while (!this.isWhole && (at < piece.length || this.left === 0)) {
      const count = Math.min(this.left, piece.length - at);
      if ((this.next.value as Next).isKept) this.bytes.push(...piece.subarray(at, at + count));
      at += count;
      this.left -= count;
      if (this.left > 0) break;
      this.next = this.parts.next(Buffer.from(this.bytes));
      this.bytes = [];
      this.left = this.isWhole ? 0 : (this.next.value as Next).length;
    }
    return at;
  }
}
