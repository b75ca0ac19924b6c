/** longer values are cut, in characters */
const LONGEST = 90;

const isPlain = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** A JSON value as one line: `x 665, y 848`, `[150, 435], [480, 510]`. An undefined value is `absent`. */
export function valueInWords(value: unknown): string {
  if (value === undefined) return 'absent';
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
