// written in pieces, so that this file does not find itself
const one = (...parts: string[]) => new RegExp(parts.join(''), 'i');

const MACHINE: readonly { readonly what: string; readonly pattern: RegExp }[] = [
  { what: 'a path of one machine', pattern: one('(?<![\\w.:/-])/', '(work|shared|home|root|Users|mnt)', '(?![\\w-])') },
  { what: 'a path of one machine', pattern: one('\\b[a-z]:\\\\', 'users\\\\') },
  {
    what: 'a host of a package registry',
    pattern: one('\\bregistry', '\\.[a-z0-9-]+\\.[a-z]', '|npm', 'mirror|verda', 'ccio|arti', 'factory'),
  },
  {
    what: 'an address of a local network',
    pattern: one('\\b(10|192\\.168|172\\.(1[6-9]|2\\d|3[01]))', '(\\.\\d{1,3}){2,3}(:\\d+)?/'),
  },
];

/** Where a text speaks of the machine it was written on rather than of the project: `line: what: the line`. */
export function machineWords(text: string): string[] {
  const found: string[] = [];
  for (const [i, line] of text.split('\n').entries()) {
    for (const { what, pattern } of MACHINE)
      if (pattern.test(line)) found.push(`${i + 1}: ${what}: ${line.trim().slice(0, 120)}`);
  }
  return found;
}
