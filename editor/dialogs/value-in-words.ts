/** Longer values are cut, characters. */
const LONGEST = 90;

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A JSON value in a line for people: `x 665, y 848`, `[150, 435], [480, 510]`; undefined is what is not there. */
export function valueInWords(value: unknown): string {
  if (value === undefined) return 'not there';
  const text = isPlain(value)
    ? Object.entries(value)
        .map(([key, inner]) => `${key} ${JSON.stringify(inner)}`)
        .join(', ')
    : Array.isArray(value)
      ? value.length === 0
        ? 'none'
        : value.map((entry) => JSON.stringify(entry)).join(', ')
      : typeof value === 'string'
        ? value
        : JSON.stringify(value);
  return text.length <= LONGEST ? text : `${text.slice(0, LONGEST - 1)}…`;
}
