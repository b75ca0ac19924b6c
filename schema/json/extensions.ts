/** Keys with this prefix are free for anyone to use: they are kept and not checked. */
const PREFIX = 'x-';

/** A copy of a JSON value without the keys that begin with x-. Recursive, so only for values of limited depth. */
export function withoutExtensions(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutExtensions);
  if (typeof value !== 'object' || value === null) return value;
  const kept = Object.entries(value).filter(([key]) => !key.startsWith(PREFIX));
  // fromEntries defines keys; an assignment to __proto__ would set the prototype
  return Object.fromEntries(kept.map(([key, inner]) => [key, withoutExtensions(inner)]));
}
