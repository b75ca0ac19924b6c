/** What holds the button: a finger, a key, a button of a gamepad. The button is down while at least one of them is. */
export class Held {
  private readonly sources = new Set<string>();

  /** @param onChange called when the button goes down or up */
  constructor(private readonly onChange: (down: boolean) => void) {}

  get down(): boolean {
    return this.sources.size > 0;
  }

  has(source: string): boolean {
    return this.sources.has(source);
  }

  press(source: string): void {
    const { size } = this.sources;
    this.sources.add(source);
    if (size === 0) this.onChange(true);
  }

  release(source: string): void {
    if (this.sources.delete(source) && this.sources.size === 0) this.onChange(false);
  }

  /** Nothing is held any more: the page was left, or the scene does not listen. */
  releaseAll(): void {
    if (this.sources.size === 0) return;
    this.sources.clear();
    this.onChange(false);
  }
}
