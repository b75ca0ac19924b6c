// en: the order must not depend on the language of the machine
const collator = new Intl.Collator('en', { numeric: true });

/** Compares paths with slashes by folder, then by name, with numbers by value: `2-b` before `10-a`. */
export const inOrderOfPlay = (a: string, b: string): number => comparePaths(a.split('/'), b.split('/'));

/** Sorts by path. Splits each path only once: splitting at every comparison would take most of the time of a long sort. */
export function sortedByPlay<T>(things: readonly T[], pathOf: (thing: T) => string): T[] {
  const keyed = things.map((thing) => ({ thing, parts: pathOf(thing).split('/') }));
  keyed.sort((a, b) => comparePaths(a.parts, b.parts));
  return keyed.map(({ thing }) => thing);
}

function comparePaths(left: readonly string[], right: readonly string[]): number {
  for (let i = 0; i < Math.min(left.length, right.length); i++) {
    const order = collator.compare(left[i], right[i]) || (left[i] < right[i] ? -1 : left[i] > right[i] ? 1 : 0);
    if (order !== 0) return order;
  }
  return left.length - right.length;
}
