import { SURPLUS } from '../tolerances.ts';

/** Initial capacity. V8 keeps so few numbers on its heap, where memory costs a tenth. */
const FEW = 8;

/**
 * Verlet's neighbour list: the objects that can matter before she has moved by `skin` px from where the list was made. Each
 * entry has the kind of event, the index of the object, and its slack: the least distance she must move before the object can
 * matter, px.
 */
export class NeighbourList {
  count = 0;
  x = 0;
  y = 0;
  skin = -1;
  /** The target for which the entries that depend on it were made. */
  target = -2;
  /** Whether entries of one kind may be in another order than an index gives when it is asked for this list alone. */
  isRough = false;
  /** Whether they must not. */
  isStrict = false;
  kind: Int32Array = new Int32Array(FEW);
  index: Int32Array = new Int32Array(FEW);
  slack: Float64Array = new Float64Array(FEW);

  /** Whether the list holds for all places within `reach` of (x, y). */
  covers(x: number, y: number, reach: number, target: number): boolean {
    return target === this.target && this.distance(x, y) + reach <= this.skin;
  }

  /** How far (x, y) is from where the list was made, px. */
  distance(x: number, y: number): number {
    const dx = x - this.x;
    const dy = y - this.y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  restart(x: number, y: number, skin: number, target: number): void {
    this.count = 0;
    this.x = x;
    this.y = y;
    this.skin = skin;
    this.target = target;
    this.isRough = false;
  }

  /** Whether two entries of one kind can matter before she has moved by `gone` px. */
  hasTwoWithin(gone: number): boolean {
    let last = -1;
    for (let i = 0; i < this.count; i++) {
      if (this.slack[i] > gone) continue;
      if (this.kind[i] === last) return true;
      last = this.kind[i];
    }
    return false;
  }

  add(kind: number, index: number, slack: number): void {
    if (slack > this.skin) return;
    if (this.count === this.kind.length) this.grow();
    this.kind[this.count] = kind;
    this.index[this.count] = index;
    this.slack[this.count] = slack;
    this.count++;
  }

  private grow(): void {
    const { kind, index, slack } = this;
    const room = 2 * kind.length;
    this.kind = new Int32Array(room);
    this.index = new Int32Array(room);
    this.slack = new Float64Array(room);
    this.kind.set(kind);
    this.index.set(index);
    this.slack.set(slack);
  }
}

/** How many times farther than asked is searched, so that the next calls need not search. */
const WIDER = 4;

/** Objects within so many times the asked distance are kept. */
const KEPT = 2;

/** More objects than this are a crowd, which is not worth keeping: it is found anew wherever she is. */
const CROWD = 16;

/** A crowd that was kept for a distance so many times the asked one has too many objects. */
const TOO_WIDE = 16;

const NONE: readonly number[] = [];

/**
 * The outer ring of a neighbour list: which objects of one list can be near her, and how far she may go before others can. So
 * objects that she is nowhere near cost nothing, however many there are. Places are in px in the level.
 */
export class Vicinity {
  /** Indices of the objects, ascending or in the order in which they were found. */
  found: ArrayLike<number> = NONE;
  private x = 0;
  private y = 0;
  /** No other object reaches nearer to (x, y) than this, px. */
  private reach = -1;
  private within = 0;

  /** Whether no object reaches nearer than `within` px to (x, y), as far as is known. */
  isEmpty(x: number, y: number, within: number): boolean {
    return this.found.length === 0 && this.holds(x, y, within);
  }

  /** Whether `found` has at least all objects that reach nearer than `within` px to (x, y). */
  covers(x: number, y: number, within: number): boolean {
    return this.holds(x, y, within) && (this.found.length <= CROWD || TOO_WIDE * within >= this.within);
  }

  private holds(x: number, y: number, within: number): boolean {
    const dx = x - this.x;
    const dy = y - this.y;
    return this.reach >= within && Math.sqrt(dx * dx + dy * dy) + within <= this.reach;
  }

  /**
   * Finds these objects anew, and how far that holds.
   * @param count - how many objects there are
   * @param edge - how near an object reaches to (x, y), px
   * @param search - gives at least all objects that reach nearer than so many px; null if all have to be examined
   * @returns the indices of at least those nearer than `within`
   */
  fill(
    x: number,
    y: number,
    within: number,
    count: number,
    edge: (i: number) => number,
    search: ((within: number) => ArrayLike<number>) | null,
  ): ArrayLike<number> {
    this.forget();
    const first = search?.(within);
    if (first !== undefined && first.length > CROWD) return first;
    const around = search?.(WIDER * within);
    const found: number[] = [];
    let reach = around === undefined ? Number.POSITIVE_INFINITY : WIDER * within;
    for (let k = 0; k < (around?.length ?? count); k++) {
      const i = around?.[k] ?? k;
      const far = edge(i);
      if (far > KEPT * within) reach = Math.min(reach, far);
      else found.push(i);
    }
    this.x = x;
    this.y = y;
    this.within = within;
    this.reach = reach - SURPLUS;
    this.found = found;
    return first ?? found;
  }

  /** Forgets what it found: objects are elsewhere, or there are more. */
  forget(): void {
    this.found = NONE;
    this.reach = -1;
  }
}
