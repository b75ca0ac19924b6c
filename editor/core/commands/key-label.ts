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
