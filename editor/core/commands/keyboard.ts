import { matchKeyBindingPress, parseKeybinding } from 'tinykeys';
import { type Commands, needsOf } from './commands.ts';

const TEXT_INPUTS = new Set(['text', 'search', 'number', 'email', 'url', 'password', 'tel']);

/** Whether keys typed at this element are input for it: a text field, a select, or an editable element. */
function takesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.isContentEditable || target instanceof HTMLTextAreaElement || target instanceof HTMLSelectElement) return true;
  return target instanceof HTMLInputElement && TEXT_INPUTS.has(target.type);
}

/** Whether a modifier that makes commands is held. Shift does not count: it types capitals and moves the focus backwards. */
const isChord = (event: KeyboardEvent): boolean => event.ctrlKey || event.metaKey || event.altKey;

/**
 * Whether a key is pressed with Ctrl or ⌘ and no other modifier: with Shift it may be the key of a command.
 * @param key as in `key` of the event, in lower case
 */
export const isModKey = (
  event: Pick<KeyboardEvent, 'ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey' | 'key'>,
  key: string,
): boolean => (event.ctrlKey || event.metaKey) && !event.shiftKey && !event.altKey && event.key.toLowerCase() === key;

/** Text fields use Ctrl or ⌘ with keys for editing; a select does not. */
function belongsToText(event: KeyboardEvent): boolean {
  if (!takesText(event.target)) return false;
  return !(event.target instanceof HTMLSelectElement && isChord(event));
}

/** Selects what covers the page; a dialog that is not modal leaves the page usable. */
export const MODAL = '[role=dialog]:not([aria-modal=false]), [role=menu], [role=listbox]';

/** Whether the key was pressed in what covers the page. */
const isOverPage = ({ target }: KeyboardEvent): boolean => target instanceof Element && target.closest(MODAL) !== null;

/** Space and Enter press a focused button, arrows move in a focused list; with Ctrl, Alt or ⌘ they do neither. */
function belongsToWidget(event: KeyboardEvent): boolean {
  if (!(event.target instanceof HTMLElement) || isChord(event)) return false;
  if (event.key === ' ' || event.key === 'Enter') {
    return event.target.closest('button, a, summary, input, [role=button], [role=tab], [role=option], [role=switch]') !== null;
  }
  if (!event.key.startsWith('Arrow')) return false;
  return event.target.closest('[role=tablist], [role=slider], [role=tree], [role=radiogroup], [role=separator], input') !== null;
}

/**
 * Runs commands by keys pressed anywhere on the page.
 * @param mode the current mode
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

const NAMES: Readonly<Record<string, string>> = {
  ArrowLeft: '←',
  ArrowRight: '→',
  ArrowUp: '↑',
  ArrowDown: '↓',
  Escape: 'Esc',
  Delete: 'Del',
  Comma: ',',
  Period: '.',
  Space: 'Space',
  Equal: '+',
  Minus: '-',
  BracketLeft: '[',
  BracketRight: ']',
  Slash: '/',
};

/** A key binding in the usual notation: `$mod+Shift+z` is `Ctrl+Shift+Z`, on a Mac `⌘⇧Z`. */
export function keyLabel(binding: string, mac: boolean): string {
  const parts = binding.split('+').map((part) => {
    if (part === '$mod') return mac ? '⌘' : 'Ctrl';
    if (part === 'Shift') return mac ? '⇧' : 'Shift';
    if (part === 'Alt') return mac ? '⌥' : 'Alt';
    const plain = part.replace(/^Key(?=[A-Z]$)|^Digit(?=\d$)/, '');
    return NAMES[plain] ?? (plain.length === 1 ? plain.toUpperCase() : plain);
  });
  return parts.join(mac ? '' : '+');
}

const ARROW = /^(.*)Arrow(?:Left|Right|Up|Down)$/;

/** The keys of a command in the usual notation; arrows with the same modifier share one label: `Shift+←→↑↓`. */
export function keyLabels(bindings: readonly string[], mac: boolean): string[] {
  const labels: string[] = [];
  let last: string | null = null;
  for (const binding of bindings) {
    const held = ARROW.exec(binding)?.[1] ?? null;
    const label = keyLabel(binding, mac);
    if (held !== null && held === last) labels.push(`${labels.pop() ?? ''}${label.slice(-1)}`);
    else labels.push(label);
    last = held;
  }
  return labels;
}
