/**
 * Verlet's neighbour list: the things that can matter before she has moved by `skin` from where the list was made.
 * Each entry keeps its slack, the distance she must move at least before it can matter.
 */
export class NeighbourList {
  count = 0;
  x = 0;
  y = 0;
  skin = -1;
  /** The target the entries that depend on one were made for. */
  target = -2;
  readonly kind: Int32Array;
  readonly index: Int32Array;
  readonly slack: Float64Array;

  constructor(capacity: number) {
    this.kind = new Int32Array(capacity);
    this.index = new Int32Array(capacity);
    this.slack = new Float64Array(capacity);
  }

  /** Whether the list still holds for all places within `reach` of (x, y). */
  covers(x: number, y: number, reach: number, target: number): boolean {
    if (target !== this.target) return false;
    const dx = x - this.x;
    const dy = y - this.y;
    return Math.sqrt(dx * dx + dy * dy) + reach <= this.skin;
  }

  restart(x: number, y: number, skin: number, target: number): void {
    this.count = 0;
    this.x = x;
    this.y = y;
    this.skin = skin;
    this.target = target;
  }

  add(kind: number, index: number, slack: number): void {
    if (slack > this.skin) return;
    this.kind[this.count] = kind;
    this.index[this.count] = index;
    this.slack[this.count] = slack;
    this.count++;
  }
}
