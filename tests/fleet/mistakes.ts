export type Path = readonly (string | number)[];

/** A copy of a file with one mistake in it. */
export interface Mistake {
  readonly what: string;
  readonly path: Path;
  readonly content: unknown;
}

/** All places within a value, the value itself left out. */
export function placesIn(value: unknown, path: Path = []): Path[] {
  if (typeof value !== 'object' || value === null) return [];
  const inside: readonly (readonly [string | number, unknown])[] = Array.isArray(value)
    ? [...value.entries()]
    : Object.entries(value);
  return inside.flatMap(([key, held]) => [[...path, key], ...placesIn(held, [...path, key])]);
}

/** A copy in which `change` has been done to whatever holds the place. */
export function changed(
  content: unknown,
  path: Path,
  change: (holder: Record<string | number, unknown>, key: string | number) => void,
) {
  const copy = structuredClone(content);
  let holder = copy as Record<string | number, unknown>;
  for (const key of path.slice(0, -1)) holder = holder[key] as Record<string | number, unknown>;
  change(holder, path[path.length - 1]);
  return copy;
}

/** Renames a key and leaves it where it was. */
function rename(holder: Record<string, unknown>, key: string): void {
  const entries = Object.entries(holder);
  for (const [name] of entries) delete holder[name];
  for (const [name, held] of entries) holder[name === key ? `${name}x` : name] = held;
}

/**
 * Every file that differs by one mistake: a misspelt key, a value of another kind, a value that is one step too far in.
 * @param isFree whether a person chooses the names in the place that has this path
 */
export function mistakesIn(content: unknown, isFree: (path: Path) => boolean): Mistake[] {
  return placesIn(content).flatMap((path) => {
    const where = `/${path.join('/')}`;
    const key = path[path.length - 1];
    const mistakes: Mistake[] = [];
    if (typeof key === 'string' && !isFree(path.slice(0, -1))) {
      mistakes.push({
        what: `${where} misspelt`,
        path,
        content: changed(content, path, (holder, key) => rename(holder, String(key))),
      });
    }
    mistakes.push({
      what: `${where} is within a key`,
      path,
      content: changed(content, path, (holder, key) => {
        holder[key] = { unheardOf: holder[key] };
      }),
    });
    return mistakes;
  });
}
