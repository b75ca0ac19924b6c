import type { GameObjects, Input, Scene } from 'phaser';

const KEYS = ['Space', 'ArrowUp'];

/** What plays the button; see `InputOptions`. */
interface Wanted {
  readonly pointer?: boolean;
  readonly keys?: readonly string[];
  readonly gamepad?: boolean;
}

/** What the runner wants to know of the button and the page. */
interface InputTarget {
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

/** What holds the button: a finger, a key, a button of a gamepad. The button is down while at least one of them is. */
class Held {
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

/** Buttons of the standard layout above this one are for menus: start, select, sticks, directions. */
const LAST_BUTTON = 7;

interface Pressed {
  readonly pad: Input.Gamepad.Gamepad;
  readonly button: Input.Gamepad.Button;
  readonly name: string;
}

/** Face buttons, shoulders and triggers of gamepads. */
class GamepadInput {
  private readonly pressed: Pressed[] = [];

  /** @param listens whether a press counts now */
  constructor(
    private readonly plugin: Input.Gamepad.GamepadPlugin,
    private readonly held: Held,
    private readonly listens: () => boolean,
  ) {
    plugin.on('down', this.onDown, this);
    plugin.on('up', this.look, this);
    plugin.on('disconnected', this.onGone, this);
  }

  private onDown(pad: Input.Gamepad.Gamepad, button: Input.Gamepad.Button): void {
    if (button.index > LAST_BUTTON || !this.listens()) return;
    const name = `gamepad ${pad.index} button ${button.index}`;
    if (!this.held.has(name)) this.pressed.push({ pad, button, name });
    this.held.press(name);
  }

  /** A gamepad that is gone holds nothing. */
  private onGone(pad: Input.Gamepad.Gamepad | undefined): void {
    const { pressed } = this;
    for (let i = pressed.length - 1; i >= 0; i--) if (pad === undefined || pressed[i].pad.index === pad.index) this.drop(i);
  }

  /** Releases what is not pressed any more; called every frame, too. */
  look(): void {
    const { pressed } = this;
    for (let i = pressed.length - 1; i >= 0; i--) {
      const { pad, button, name } = pressed[i];
      if (!button.pressed || !pad.connected || !this.held.has(name)) this.drop(i);
    }
  }

  private drop(i: number): void {
    const { pressed } = this;
    const { name } = pressed[i];
    pressed[i] = pressed[pressed.length - 1];
    pressed.length--;
    this.held.release(name);
  }

  destroy(): void {
    this.plugin.off('down', this.onDown, this);
    this.plugin.off('up', this.look, this);
    this.plugin.off('disconnected', this.onGone, this);
    this.pressed.length = 0;
  }
}

/** Elements that use keys themselves while they have the focus. */
const USES_KEYS = 'input, textarea, select, button, a[href], summary, [contenteditable]';

const usesKeys = (target: EventTarget | null): boolean =>
  target !== null && 'closest' in target && (target as Element).closest(USES_KEYS) !== null;

/**
 * Listens to keys. They come from the page, as Phaser hands an event to one game of a page only, and none to a paused scene, so
 * that a release would be missed.
 *
 * @param listens whether a press counts now
 * @returns ends it
 */
function listenToKeys(codes: readonly string[], held: Held, listens: () => boolean): () => void {
  const onDown = (event: KeyboardEvent) => {
    const { code, repeat, ctrlKey, altKey, metaKey, target } = event;
    if (!codes.includes(code) || ctrlKey || altKey || metaKey || !listens() || usesKeys(target)) return;
    // the page would scroll
    event.preventDefault();
    if (!repeat) held.press(code);
  };
  const onUp = ({ code, key }: KeyboardEvent) => {
    held.release(code);
    // macOS does not report the release of a key while Command is held
    if (key === 'Meta') for (const one of codes) held.release(one);
  };
  window.addEventListener('keydown', onDown);
  window.addEventListener('keyup', onUp);
  return () => {
    window.removeEventListener('keydown', onDown);
    window.removeEventListener('keyup', onUp);
  };
}

type Pointer = Input.Pointer;

const nameOf = ({ id }: Pointer): string => `pointer ${id}`;

/** Whether it presses: a finger, or the main button of a mouse. */
const isDown = (pointer: Pointer): boolean => (pointer.wasTouch ? pointer.isDown : pointer.primaryDown);

/** Mouse, pen and fingers on the canvas. */
class PointerInput {
  private readonly down: Pointer[] = [];

  /** @param counts whether a press at a place of the canvas counts */
  constructor(
    private readonly scene: Scene,
    private readonly held: Held,
    private readonly counts: (x: number, y: number) => boolean,
  ) {
    scene.input.on('pointerdown', this.onDown, this);
    scene.input.on('pointerup', this.look, this);
    scene.input.on('pointerupoutside', this.look, this);
  }

  private onDown(pointer: Pointer, over: readonly GameObjects.GameObject[]): void {
    // a button of the game is not the gun's
    if (over.length > 0 || !isDown(pointer) || !this.counts(pointer.x, pointer.y)) return;
    if (!this.down.includes(pointer)) this.down.push(pointer);
    this.held.press(nameOf(pointer));
  }

  /**
   * Releases what is not down any more. Called every frame, too: Phaser does not report to this scene that a pointer goes up
   * over a button of another scene, or outside of the window.
   */
  look(): void {
    const { down } = this;
    for (let i = down.length - 1; i >= 0; i--) {
      const pointer = down[i];
      if (isDown(pointer) && this.held.has(nameOf(pointer))) continue;
      down[i] = down[down.length - 1];
      down.length--;
      this.held.release(nameOf(pointer));
    }
  }

  destroy(): void {
    const { input } = this.scene;
    input.off('pointerdown', this.onDown, this);
    input.off('pointerup', this.look, this);
    input.off('pointerupoutside', this.look, this);
    this.down.length = 0;
  }
}
