import { type Change, swapped } from './change.ts';

const keysBack = <T extends { readonly before: unknown; readonly after: unknown }>(keys: T): T => ({
  ...keys,
  before: keys.after,
  after: keys.before,
});

/** The change in the other direction: what leads from the second version to the first. */
export function reversed(change: Change): Change {
  switch (change.type) {
    case 'value':
      return { type: 'value', ...swapped(change) };
    case 'map': {
      const { of, fields, keys, empty } = change;
      return { type: 'map', of, fields: fields.map(swapped), keys: keys && keysBack(keys), empty: keysBack(empty) };
    }
    case 'added':
      return { ...change, type: 'removed' };
    case 'removed':
      return { ...change, type: 'added' };
    case 'changed': {
      const { fields, keys } = change;
      return { ...keysBack(change), fields: fields.map(swapped), keys: keys && keysBack(keys) };
    }
    case 'order': {
      const pairs = change.pairs.map(([before, after]) => [after, before] as const);
      return { ...change, pairs: pairs.sort((p, q) => p[1] - q[1]) };
    }
    case 'empty-list':
    case 'keys':
      return keysBack(change);
  }
}
