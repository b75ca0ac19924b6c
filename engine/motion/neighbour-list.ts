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
  kind: Int32Array = new Int32Array(FEW);
  index: Int32Array = new Int32Array(FEW);
  slack: Float64Array = new Float64Array(FEW);

  /** Whether the list holds for all places within `reach` of (x, y). */
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
