/** Numbers by whole numbers from 0 to 2^48: 32 bytes for each at most, where a Map takes three times as much. */
export class NumberTable {
  private keys = new Float64Array(1024).fill(-1);
  private values = new Float64Array(1024);
  private count = 0;

  get size(): number {
    return this.count;
  }

  get(key: number): number | undefined {
    const at = this.placeOf(key);
    return this.keys[at] === key ? this.values[at] : undefined;
  }

  set(key: number, value: number): void {
    const at = this.placeOf(key);
    this.values[at] = value;
    if (this.keys[at] === key) return;
    this.keys[at] = key;
    this.count++;
    if (2 * this.count > this.keys.length) this.grow();
  }

  *entries(): Generator<readonly [key: number, value: number]> {
    for (const [at, key] of this.keys.entries()) if (key >= 0) yield [key, this.values[at]];
  }

  /** Where a key is, or may be put. The keys are parts of hashes, so they are spread already. */
  private placeOf(key: number): number {
    const { keys } = this;
    let at = key % keys.length;
    while (keys[at] >= 0 && keys[at] !== key) at = (at + 1) % keys.length;
    return at;
  }

  private grow(): void {
    const { keys, values } = this;
    this.keys = new Float64Array(2 * keys.length).fill(-1);
    this.values = new Float64Array(2 * keys.length);
    for (const [i, key] of keys.entries()) {
      if (key < 0) continue;
      const at = this.placeOf(key);
      this.keys[at] = key;
      this.values[at] = values[i];
    }
  }
}
