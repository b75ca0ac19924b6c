import type { Scene } from 'phaser';
import { GamepadInput } from './gamepad-input.ts';
import { Held } from './held.ts';
import { listenToKeys } from './key-input.ts';
import { PointerInput } from './pointer-input.ts';

const KEYS = ['Space', 'ArrowUp'];

/** What plays the button; see `InputOptions`. */
interface Wanted {
  readonly pointer?: boolean;
  readonly keys?: readonly string[];
  readonly gamepad?: boolean;
}

/** What the runner wants to know of the button and the page. */
export interface InputTarget {
  /** The button went down or up. */
  onButton(down: boolean): void;
  /** The page was hidden or is shown again. */
  onVisible(visible: boolean): void;
  /** Whether a press at a place of the canvas counts. */
  covers(x: number, y: number): boolean;
}

/** The gun's button, however it is played, and whether the page is visible. */
export class GunInput {
  private readonly held: Held;
  private readonly pointer: PointerInput | null;
  private readonly gamepad: GamepadInput | null;
  private readonly ends: (() => void)[] = [];

  constructor(scene: Scene, wanted: Wanted | false, target: InputTarget) {
    const held = new Held((down) => target.onButton(down));
    this.held = held;
    const {
      pointer = true,
      keys = KEYS,
      gamepad = true,
    } = wanted === false ? { pointer: false, keys: [], gamepad: false } : wanted;
    const plugin = scene.input as typeof scene.input | null;
    const listens = () => scene.sys.isActive() && plugin?.enabled !== false;
    this.pointer = pointer && plugin ? new PointerInput(scene, held, (x, y) => target.covers(x, y)) : null;
    // absent unless the game's configuration asks for it
    const pads = gamepad ? (plugin?.gamepad ?? null) : null;
    this.gamepad = pads === null ? null : new GamepadInput(pads, held, listens);
    if (keys.length > 0) this.ends.push(listenToKeys(keys, held, listens));
    this.listenToPage(target);
    const release = () => held.releaseAll();
    for (const name of ['pause', 'sleep']) {
      scene.sys.events.on(name, release);
      this.ends.push(() => scene.sys.events.off(name, release));
    }
  }

  /** What is held when the page loses the focus may be released elsewhere. Phaser reports it to one game of a page only. */
  private listenToPage({ onVisible }: InputTarget): void {
    const onBlur = () => this.held.releaseAll();
    const onChange = () => {
      if (document.hidden) this.held.releaseAll();
      onVisible(!document.hidden);
    };
    window.addEventListener('blur', onBlur);
    document.addEventListener('visibilitychange', onChange);
    this.ends.push(() => {
      window.removeEventListener('blur', onBlur);
      document.removeEventListener('visibilitychange', onChange);
    });
  }

  /** Whether the button is down. */
  get down(): boolean {
    return this.held.down;
  }

  /** Called every frame. */
  look(): void {
    this.pointer?.look();
    this.gamepad?.look();
  }

  destroy(): void {
    this.pointer?.destroy();
    this.gamepad?.destroy();
    for (const end of this.ends) end();
    this.held.releaseAll();
  }
}
