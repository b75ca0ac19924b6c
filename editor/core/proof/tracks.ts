/** initial number of entries of a track */
const ROOM = 256;

/**
 * The positions of many objects at every entry of a trajectory, `size` doubles each. Most objects of a large level never move:
 * for an object at its initial state nothing is stored, however many entries there are. The arrays are reused.
 */
export class Tracks {
  /** The number of objects. */
  count = 0;
  /** The initial state of each object. */
  private start = new Float64Array(0);
  /** The entry from which on an object's track is stored; infinite while it has not moved. */
  private readonly since: number[] = [];
  private readonly written: Float64Array[] = [];
  /** Whether the track of any object is stored. */
  private haveStirred = false;

  /** @param size doubles per object */
  constructor(readonly size: number) {}

  /** Starts over. @param count number of objects */
  clear(count: number): void {
    this.count = count;
    if (this.start.length < count * this.size) this.start = new Float64Array(count * this.size);
    for (let i = 0; i < count; i++) this.since[i] = Number.POSITIVE_INFINITY;
    this.haveStirred = false;
  }

  /** Writes an entry and discards later ones; earlier ones must have been written. @param states of all objects in order */
  write(entry: number, states: Float64Array): void {
    const { count, size, start, since } = this;
    if (entry === 0) {
      start.set(states);
      for (let i = 0; i < count; i++) since[i] = Number.POSITIVE_INFINITY;
      this.haveStirred = false;
      return;
    }
    // usually nothing has moved, and this is called in every tick
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

  /** Whether an object ever differs from its initial state. */
  stirs(body: number): boolean {
    return this.since[body] < Number.POSITIVE_INFINITY;
  }

  /** Copies the state of an object at an entry to `out`, from `at` on. */
  read(body: number, entry: number, out: Float64Array, at = 0): void {
    const { size, start, since, written } = this;
    const from = since[body];
    const [list, o] = entry < from ? [start, size * body] : [written[body], size * (entry - from)];
    for (let k = 0; k < size; k++) out[at + k] = list[o + k];
  }

  /** The states of all objects at an entry, in order. */
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
