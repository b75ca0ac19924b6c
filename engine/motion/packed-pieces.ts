import type { Motion } from './motion.ts';
import { HEAD, SLOTS } from './state.ts';

const { DEGREE, BASE_X, BASE_Y, ACCELERATION } = SLOTS;

/** Numbers in the first block, enough for most runs. Each block has as many as all before it, up to the largest. */
const FIRST_BLOCK = 2048;
const LARGEST_BLOCK = 65_536;

/**
 * What describes her on each of many pieces: the slots at the head of the state, and as many coefficients as the piece has.
 * They share blocks of memory, because an array for each piece takes longer to create than to fill.
 */
export class PackedPieces {
  private readonly blocks: Float64Array[] = [];
  /** How many numbers of the last block are in use. */
  private used = 0;
  /** How many numbers all blocks have. */
  private room = 0;
  /** For each piece, the index of its block, and of its first number in that. */
  private readonly blockOf: number[] = [];
  private readonly from: number[] = [];

  /**
   * Adds the piece that the motion is on.
   * @returns how many numbers it takes
   */
  add(m: Motion): number {
    const { s, ux, uy, px, py } = m;
    const length = s[DEGREE] + 1;
    const size = HEAD + length * (m.recoil ? 4 : 2);
    const block = this.blockFor(size);
    let at = this.used;
    this.blockOf.push(this.blocks.length - 1);
    this.from.push(at);
    for (let k = 0; k < HEAD; k++) block[at++] = s[k];
    for (let k = 0; k < length; k++) block[at++] = ux[k];
    for (let k = 0; k < length; k++) block[at++] = uy[k];
    if (m.recoil) {
      for (let k = 0; k < length; k++) block[at++] = px[k];
      for (let k = 0; k < length; k++) block[at++] = py[k];
    }
    this.used = at;
    return size;
  }

  /** Restores piece `i` to the state of the motion. */
  restore(i: number, m: Motion): void {
    const { s, ux, uy, px, py } = m;
    const block = this.blocks[this.blockOf[i]];
    let at = this.from[i];
    for (let k = 0; k < HEAD; k++) s[k] = block[at++];
    const length = s[DEGREE] + 1;
    for (let k = 0; k < length; k++) ux[k] = block[at++];
    for (let k = 0; k < length; k++) uy[k] = block[at++];
    if (!m.recoil) return;
    for (let k = 0; k < length; k++) px[k] = block[at++];
    for (let k = 0; k < length; k++) py[k] = block[at++];
  }

  /**
   * Reads where piece `i` begins, if no recoil acts on it: writes her place relative to the origin, her velocity, and the bound of
   * her acceleration to out[0..4].
   */
  startOf(i: number, out: Float64Array): void {
    const block = this.blocks[this.blockOf[i]];
    const at = this.from[i];
    const x = at + HEAD;
    const y = x + block[at + DEGREE] + 1;
    out[0] = block[at + BASE_X] + block[x];
    out[1] = block[at + BASE_Y] + block[y];
    out[2] = y - x > 1 ? block[x + 1] : 0;
    out[3] = y - x > 1 ? block[y + 1] : 0;
    out[4] = block[at + ACCELERATION];
  }

  /**
   * Reads where piece `i` leads within `t` s, if no recoil acts on it: writes her place then, relative to the origin, to out[0..1],
   * and to out[2] an upper bound of how far she is from the straight way there, px.
   */
  chordOf(i: number, t: number, out: Float64Array): void {
    const block = this.blocks[this.blockOf[i]];
    const at = this.from[i];
    const degree = block[at + DEGREE];
    const x = at + HEAD;
    const y = x + degree + 1;
    let toX = block[at + BASE_X] + block[x];
    let toY = block[at + BASE_Y] + block[y];
    let bend = 0;
    for (let k = 1, power = t; k <= degree; k++, power *= t) {
      const dx = block[x + k] * power;
      const dy = block[y + k] * power;
      toX += dx;
      toY += dy;
      // c t^k strays from its own chord by at most c t^k; by a quarter of that where k is 2
      if (k > 1) bend += (Math.abs(dx) + Math.abs(dy)) * (k === 2 ? 0.25 : 1);
    }
    out[0] = toX;
    out[1] = toY;
    out[2] = bend;
  }

  /** A block with room for `size` more numbers. */
  private blockFor(size: number): Float64Array {
    const { blocks } = this;
    const last = blocks.at(-1);
    if (last !== undefined && this.used + size <= last.length) return last;
    const block = new Float64Array(Math.max(size, this.room === 0 ? FIRST_BLOCK : Math.min(LARGEST_BLOCK, this.room)));
    blocks.push(block);
    this.room += block.length;
    this.used = 0;
    return block;
  }
}
