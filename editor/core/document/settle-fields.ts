/** Why a change was refused, for the user. */
export interface Refusal {
  readonly message: string;
  readonly hint: string;
}

type Json = { [key: string]: unknown };
type Shape = { readonly [key: string]: { safeParse(value: unknown): { success: boolean } } };

/** The fields that an object of a file may have. */
export interface Fields {
  readonly shape: Shape;
  /** The ranges of its numbers. */
  readonly limits: Readonly<Record<string, readonly [least: number, most: number]>>;
  /** Its required fields. */
  readonly required: readonly string[];
}

const ID = /^[a-z0-9]{2,16}$/;

const TEXT_LIMITS: Readonly<Record<string, number>> = { description: 2000 };

/** Thrown where a change is refused. */
export class Refused extends Error {
  constructor(readonly refusal: Refusal) {
    super(refusal.message);
  }
}

/** Refuses a change. */
export const refuse = (message: string, hint: string): never => {
  throw new Refused({ message, hint });
};

/** Cuts a text to a length without splitting a surrogate pair. */
export function cut(text: string, most: number): string {
  if (text.length <= most) return text;
  const last = text.charCodeAt(most - 1);
  return text.slice(0, last >= 0xd800 && last < 0xdc00 ? most - 1 : most);
}

/** The settled value of a field; undefined omits it. */
function settleField(key: string, value: unknown, fields: Fields, what: string): unknown {
  if (value === undefined || key.startsWith('x-')) return value;
  if (!Object.hasOwn(fields.shape, key)) refuse(`${what} has no ${key}`, 'Custom keys begin with x-.');
  if (typeof value === 'number' && Object.hasOwn(fields.limits, key)) {
    if (Number.isNaN(value)) refuse(`${key} of ${what} would not be a number`, 'Type a number.');
    const [least, most] = fields.limits[key];
    // + 0 turns -0 into 0, which is how a file stores it
    return Math.min(most, Math.max(least, value)) + 0;
  }
  if (typeof value === 'string' && Object.hasOwn(TEXT_LIMITS, key)) return cut(value, TEXT_LIMITS[key]);
  if (key === 'id') return typeof value === 'string' && ID.test(value) ? value : undefined;
  if (!fields.shape[key].safeParse(value).success)
    refuse(`${key} of ${what} can't be ${JSON.stringify(value)}`, 'Give it another value.');
  return value;
}

/**
 * @param old an object that is settled: fields equal in both are skipped
 * @returns the same object if nothing changes
 */
export function settleFields<T extends object>(value: T, fields: Fields, what: string, old?: object): T {
  let changed: Json | null = null;
  const before = old as Json | undefined;
  for (const key of Object.keys(value)) {
    const field = (value as Json)[key];
    if (before !== undefined && field !== undefined && Object.is(before[key], field)) continue;
    const settled = settleField(key, field, fields, what);
    if (field !== undefined && Object.is(settled, field)) continue;
    changed ??= { ...value } as Json;
    if (settled === undefined) delete changed[key];
    else changed[key] = settled;
  }
  for (const key of fields.required) {
    if (!Object.hasOwn(changed ?? value, key)) refuse(`${what} has no ${key}`, `Give it a ${key}.`);
  }
  return (changed as T | null) ?? value;
}
