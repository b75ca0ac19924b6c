import { matchKeyBindingPress, parseKeybinding } from 'tinykeys';
import { type Commands, needsOf } from './commands.ts';

const TEXT_INPUTS = new Set(['text', 'search', 'number', 'email', 'url', 'password', 'tel']);

/** Whether keys typed at this element are meant for it: a text field, a select, or what is edited in place. */
export function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && TEXT_INPUTS.has(target.type);
}

/** Whether a key is pressed together with one that makes it a command. Shift makes other letters and walks backwards: it is none of them. */
const isChord = (event: KeyboardEvent): boolean => event.ctrlKey || event.metaKey || event.altKey;

/** Keys that edit a text together with Ctrl, or ⌘: there is nothing of them in a list of choices. */
function belongsToText(event: KeyboardEvent): boolean {
  if (!takesText(event.target)) return false;
  return !(event.target instanceof HTMLSelectElement && isChord(event));
}

/** Whether something lies over the page that is to be dealt with first; a dialog that is not modal leaves the page as it is. */
const isOverPage = ({ target }: KeyboardEvent): boolean =>
  target instanceof Element && target.closest('[role=dialog]:not([aria-modal=false]), [role=menu], [role=listbox]') !== null;

/** Space and Enter press a button, and arrows walk in a list, when those have the focus; with Ctrl, Alt or ⌘ they do neither. */
function belongsToWidget(event: KeyboardEvent): boolean {
  if (!(event.target instanceof HTMLElement) || isChord(event)) return false;
  if (event.key === ' ' || event.key === 'Enter') {
    return event.target.closest('button, a, summary, input, [role=button], [role=tab], [role=option], [role=switch]') !== null;
  }
  if (!event.key.startsWith('Arrow')) return false;
  return event.target.closest('[role=tablist], [role=slider], [role=tree], [role=radiogroup], [role=separator], input') !== null;
}

/**
 * Gives keys pressed anywhere on the page to the commands.
 * @param mode what the person is doing now
 * @returns stops listening
 */
export function listenToKeys(page: Window, commands: Commands, mode: () => 'edit' | 'play'): () => void {
  const onKey = (event: KeyboardEvent) => {
    if (event.defaultPrevented || event.isComposing) return;
    const inText = belongsToText(event);
    const inWidget = belongsToWidget(event);
    const inDialog = isOverPage(event);
    for (const command of commands.all()) {
      if (command.keys === undefined) continue;
      if (inDialog && command.inDialogs !== true) continue;
      if ((inText || inWidget) && command.inText !== true) continue;
      const when = command.mode ?? 'edit';
      if (when !== 'both' && when !== mode()) continue;
      const matches = command.keys.some((key) => {
        const presses = parseKeybinding(key);
        return presses.length === 1 && matchKeyBindingPress(event, presses[0]);
      });
      if (!matches || needsOf(command) !== null) continue;
      event.preventDefault();
      command.run(event);
      return;
    }
  };
  page.addEventListener('keydown', onKey);
  return () => page.removeEventListener('keydown', onKey);
}
