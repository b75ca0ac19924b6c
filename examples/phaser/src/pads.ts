import { moveFocus } from './focus.ts';

/** Buttons of the standard gamepad. */
const A = 0;
const B = 1;
const START = 9;
const DIRECTIONS: readonly (readonly [number, readonly [number, number]])[] = [
  [12, [0, -1]],
  [13, [0, 1]],
  [14, [-1, 0]],
  [15, [1, 0]],
];
/** A stick counts from here. */
const TILTED = 0.6;

export interface PadActions {
  /** Whether the gamepad plays: the runner reads it then. */
  isPlaying(): boolean;
  pause(): void;
  back(): void;
  /** A button was pressed. */
  wake(): void;
}

/** Lets gamepads use menus and panels: A chooses, B goes back, Start pauses, stick and cross move the focus. */
export function followGamepads(actions: PadActions): void {
  let last: ReadonlySet<number> = new Set();
  let isFollowing = false;

  const downNow = (): Set<number> => {
    const down = new Set<number>();
    for (const pad of navigator.getGamepads()) {
      if (pad === null) continue;
      for (const [i, { pressed }] of pad.buttons.entries()) if (pressed) down.add(i);
      const [x = 0, y = 0] = pad.axes;
      if (y < -TILTED) down.add(12);
      if (y > TILTED) down.add(13);
      if (x < -TILTED) down.add(14);
      if (x > TILTED) down.add(15);
    }
    return down;
  };
  const look = () => {
    if (!navigator.getGamepads().some((pad) => pad !== null)) {
      isFollowing = false;
      return;
    }
    requestAnimationFrame(look);
    const down = downNow();
    const isNew = (button: number) => down.has(button) && !last.has(button);
    if (down.size > 0) actions.wake();
    if (actions.isPlaying()) {
      if (isNew(START)) actions.pause();
    } else {
      const root =
        document.querySelector<HTMLElement>('dialog[open]') ?? document.querySelector<HTMLElement>('main:not([hidden])');
      for (const [button, step] of DIRECTIONS) if (isNew(button) && root !== null) moveFocus(root, step);
      if (isNew(A) && document.activeElement instanceof HTMLElement) document.activeElement.click();
      if (isNew(B) || isNew(START)) actions.back();
    }
    last = down;
  };
  addEventListener('gamepadconnected', () => {
    if (isFollowing) return;
    isFollowing = true;
    requestAnimationFrame(look);
  });
}
