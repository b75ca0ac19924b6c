import { type Commands, needsOf, type PadButton } from './commands.ts';
import { MODAL } from './keyboard.ts';

/** Buttons of the standard gamepad layout that start commands, by index: https://www.w3.org/TR/gamepad/#remapping */
const INDICES: Readonly<Record<PadButton, number>> = { A: 0, Select: 8, Start: 9, Up: 12, Down: 13, Left: 14, Right: 15 };

/** The face buttons, shoulders and triggers hold the gun, as in the game; the others are for menus. */
const LAST_GUN_BUTTON = 7;

/** A stick counts from here; its ends are at 1. */
const TILTED = 0.6;

/** A button that went down or up. */
interface PadPress {
  /** Unique among all buttons of all gamepads. */
  readonly source: string;
  readonly isDown: boolean;
  /** null: a button without a name */
  readonly name: PadButton | null;
  readonly holdsGun: boolean;
}

type PadPage = Pick<Window, 'addEventListener' | 'removeEventListener' | 'requestAnimationFrame' | 'cancelAnimationFrame'> & {
  readonly navigator: Partial<Pick<Navigator, 'getGamepads'>>;
};

const nameOf = (button: number): PadButton | null =>
  (Object.keys(INDICES) as PadButton[]).find((name) => INDICES[name] === button) ?? null;

/** The connected gamepads; none where the browser or the page's host forbids them. */
function padsOf({ navigator }: PadPage): Gamepad[] {
  try {
    return navigator.getGamepads?.().filter((pad) => pad !== null) ?? [];
  } catch {
    return [];
  }
}

/** The buttons of a gamepad that are down, by index. */
function downOn({ buttons, axes }: Gamepad): Set<number> {
  const down = new Set<number>();
  for (const [button, { pressed }] of buttons.entries()) if (pressed) down.add(button);
  const [x = 0, y = 0] = axes;
  if (y < -TILTED) down.add(INDICES.Up);
  if (y > TILTED) down.add(INDICES.Down);
  if (x < -TILTED) down.add(INDICES.Left);
  if (x > TILTED) down.add(INDICES.Right);
  return down;
}

/**
 * Calls back for every button of a gamepad that goes down or up. Browsers report no such events, so the gamepads are looked at
 * once per frame, while there are any. A gamepad that is gone holds nothing.
 * @returns stops it, and lets go of what is held
 */
export function followGamepads(page: PadPage, onPress: (press: PadPress) => void): () => void {
  const held = new Map<string, number>();
  let frame: number | null = null;
  const tell = (source: string, button: number, isDown: boolean) =>
    onPress({ source, isDown, name: nameOf(button), holdsGun: button <= LAST_GUN_BUTTON });
  const releaseAllBut = (down: ReadonlyMap<string, number>) => {
    for (const [source, button] of held) {
      if (down.has(source)) continue;
      held.delete(source);
      tell(source, button, false);
    }
  };
  const look = () => {
    const pads = padsOf(page);
    frame = pads.length > 0 ? page.requestAnimationFrame(look) : null;
    const down = new Map<string, number>();
    for (const pad of pads) for (const button of downOn(pad)) down.set(`gamepad ${pad.index} button ${button}`, button);
    releaseAllBut(down);
    for (const [source, button] of down) {
      if (held.has(source)) continue;
      held.set(source, button);
      tell(source, button, true);
    }
  };
  const begin = () => {
    frame ??= page.requestAnimationFrame(look);
  };
  page.addEventListener('gamepadconnected', begin);
  // one that was there before the page listened is not announced again
  begin();
  return () => {
    page.removeEventListener('gamepadconnected', begin);
    if (frame !== null) page.cancelAnimationFrame(frame);
    releaseAllBut(new Map());
  };
}

/**
 * Runs commands by buttons of gamepads.
 * @param mode the current mode
 * @returns stops listening
 */
export function listenToPads(page: Window, commands: Commands, mode: () => 'edit' | 'play'): () => void {
  return followGamepads(page, ({ name, isDown }) => {
    if (!isDown || name === null || page.document.querySelector(MODAL) !== null) return;
    const command = commands
      .all()
      .find((one) => one.pad === name && [mode(), 'both'].includes(one.mode ?? 'edit') && needsOf(one) === null);
    command?.run();
  });
}
