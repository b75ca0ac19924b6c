import { type Commands, needsOf } from './commands.ts';
import { followGamepads } from './gamepads.ts';
import { MODAL } from './keyboard.ts';

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
