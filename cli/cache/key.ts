import { createHash } from 'node:crypto';

/** A text that is the same for equal plain data, whatever the order of its keys, and different for different data. */
function canonical(value: unknown): string {
  if (Array.isArray(value)) return `[${value.map(canonical).join(',')}]`;
  if (typeof value === 'object' && value !== null) {
    const fields = Object.entries(value)
      .sort(([a], [b]) => (a < b ? -1 : 1))
      .map(([key, field]) => `${JSON.stringify(key)}:${canonical(field)}`);
    return `{${fields.join(',')}}`;
  }
  switch (typeof value) {
    case 'string':
      return JSON.stringify(value);
    case 'number':
      // JSON has one text for several numbers: null, and 0
      return Object.is(value, -0) ? '-0' : String(value);
    case 'boolean':
    case 'undefined':
    case 'object':
      return String(value);
    default:
      throw new TypeError(`expected plain data, found a ${typeof value}`);
  }
}

/** A key for plain data, 64 digits in base 16. */
export const keyOf = (data: unknown): string => createHash('sha256').update(canonical(data)).digest('hex');

/** A key for the bytes of a file under a key of everything else that the result depends on. */
export const contentKey = (key: string, bytes: Uint8Array): string =>
  createHash('sha256').update(key).update(bytes).digest('hex');
