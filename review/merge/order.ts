/** Which of two lists of texts comes first: a fixed order, which does not depend on who is called mine. */
function compareLists(p: readonly string[], q: readonly string[]): number {
  for (let i = 0; i < p.length && i < q.length; i++) if (p[i] !== q[i]) return p[i] < q[i] ? -1 : 1;
  return p.length - q.length;
}

/** Names that are not common to all, by the common name that they follow; null for those before the first. */
function followers(
  list: readonly string[],
  isCommon: (name: string) => boolean,
  kept: ReadonlySet<string>,
): Map<string | null, string[]> {
  const after = new Map<string | null, string[]>();
  let anchor: string | null = null;
  for (const name of list) {
    if (isCommon(name)) anchor = name;
    else if (kept.has(name)) {
      const group = after.get(anchor);
      if (group === undefined) after.set(anchor, [name]);
      else group.push(name);
    }
  }
  return after;
}

/**
 * Puts entries of two versions of a list into one order. Entries that only some versions have go where their version has them.
 * @param choose merges the order of the entries that all versions have
 * @param kept the names of the entries that the result has; each is in `mine` or `theirs`
 */
export function mergeOrder(
  bases: readonly (readonly string[])[],
  mine: readonly string[],
  theirs: readonly string[],
  kept: ReadonlySet<string>,
  choose: (bases: readonly string[][], mine: string[], theirs: string[]) => readonly string[],
): string[] {
  const all = [mine, theirs, ...bases].map((names) => new Set(names));
  const isCommon = (name: string) => kept.has(name) && all.every((names) => names.has(name));
  const [m, t, ...b] = [mine, theirs, ...bases].map((list) => list.filter(isCommon));
  const [hereAfter, thereAfter] = [followers(mine, isCommon, kept), followers(theirs, isCommon, kept)];
  const result = new Set<string>();
  for (const anchor of [null, ...choose(b, m, t)]) {
    if (anchor !== null) result.add(anchor);
    const groups = [hereAfter.get(anchor) ?? [], thereAfter.get(anchor) ?? []];
    groups.sort(compareLists);
    for (const name of groups.flat()) result.add(name);
  }
  return [...result];
}

/** The keys of two versions of an object: those of the base first, in its order, and then the new ones, sorted. */
export function keysInOrder(base: Iterable<string>, mine: Iterable<string>, theirs: Iterable<string>): string[] {
  const all = new Set([...mine, ...theirs]);
  const old = new Set([...base].filter((key) => all.has(key)));
  return [...old, ...[...all].filter((key) => !old.has(key)).sort()];
}
