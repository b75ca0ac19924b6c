/** Keys that begin so belong to whoever wrote them: they are kept and never looked into. */
const PREFIX = 'x-';

/** A copy of a JSON value without the keys that begin with x-. Recursive: for values of limited depth. */
export function withoutExtensions(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutExtensions);
  if (typeof value !== 'object' || value === null) return value;
  const kept = Object.entries(value).filter(([key]) => !key.startsWith(PREFIX));
  // fromEntries defines keys, assignment would set the prototype for __proto__
  return Object.fromEntries(kept.map(([key, inner]) => [key, withoutExtensions(inner)]));
}
