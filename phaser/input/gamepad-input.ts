import type { Input } from 'phaser';
import type { Held } from './held.ts';

/** Buttons of the standard layout above this one are for menus: start, select, sticks, directions. */
const LAST_BUTTON = 7;

interface Pressed {
  readonly pad: Input.Gamepad.Gamepad;
  readonly button: Input.Gamepad.Button;
  readonly name: string;
}

/** Face buttons, shoulders and triggers of gamepads. */
export class GamepadInput {
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
