/** Entries for which a track has room at first. */
const ROOM = 256;

/**
 * Where many bodies are at every entry of a way, `size` doubles each. Most of a large level never stirs: of a body that is where it was at first nothing
 * is written, however many entries there are. The arrays are kept from way to way.
 */
export class Tracks {
  /** How many bodies there are. */
  count = 0;
  /** What each body begins with. */
  private start = new Float64Array(0);
  /** The entry from which on a body's track is written; infinite while it has not stirred. */
  private readonly since: number[] = [];
  private readonly written: Float64Array[] = [];
  /** Whether any body's track is written. */
  private haveStirred = false;

  /** @param size doubles that say how one body is */
  constructor(readonly size: number) {}

  /** Begins anew. @param count of bodies */
  clear(count: number): void {
    this.count = count;
    if (this.start.length < count * this.size) this.start = new Float64Array(count * this.size);
    for (let i = 0; i < count; i++) this.since[i] = Number.POSITIVE_INFINITY;
    this.haveStirred = false;
  }

  /** Writes an entry; those that come after it are forgotten, those before it must be written. @param states of all bodies, one after the other */
  write(entry: number, states: Float64Array): void {
    const { count, size, start, since } = this;
    if (entry === 0) {
      start.set(states);
      for (let i = 0; i < count; i++) since[i] = Number.POSITIVE_INFINITY;
      this.haveStirred = false;
      return;
    }
    // most of the time nothing has, and this is asked in every tick
    if (!this.haveStirred && !stirs(states, start, 0, size * count)) return;
    this.haveStirred = false;
    for (let i = 0; i < count; i++) {
      const from = since[i];
      if (from < entry || stirs(states, start, size * i, size)) {
        this.haveStirred = true;
        this.keep(i, entry, states);
      } else since[i] = Number.POSITIVE_INFINITY;
    }
  }

  /** Whether a body ever is elsewhere, or otherwise, than at first. */
  stirs(body: number): boolean {
    return this.since[body] < Number.POSITIVE_INFINITY;
  }

  /** Writes how a body is at an entry into `out`, from `at` on. */
  read(body: number, entry: number, out: Float64Array, at = 0): void {
    const { size, start, since, written } = this;
    const from = since[body];
    const [list, o] = entry < from ? [start, size * body] : [written[body], size * (entry - from)];
    for (let k = 0; k < size; k++) out[at + k] = list[o + k];
  }

  /** How all bodies are at an entry, one after the other. */
  all(entry: number): Float64Array {
    const out = new Float64Array(this.count * this.size);
    for (let i = 0; i < this.count; i++) this.read(i, entry, out, this.size * i);
    return out;
  }

  private keep(body: number, entry: number, states: Float64Array): void {
    const { size, since, written } = this;
    since[body] = Math.min(since[body], entry);
    const o = size * (entry - since[body]);
    let list = written[body] ?? new Float64Array(size * ROOM);
    if (o + size > list.length) {
      const grown = new Float64Array(2 * list.length);
      grown.set(list);
      list = grown;
    }
    written[body] = list;
    for (let k = 0; k < size; k++) list[o + k] = states[size * body + k];
  }
}

function stirs(states: Float64Array, start: Float64Array, from: number, size: number): boolean {
  for (let k = from; k < from + size; k++) if (states[k] !== start[k]) return true;
  return false;
}
