import fc from 'fast-check';
import { expect, test } from 'vitest';
import { createLocator } from '../../schema/json/locate.ts';

test('a string ends at the first unescaped quote, however many backslashes there are', () => {
  // strings of quotes, backslashes and brackets before the located value, as keys and as values
  const tricky = fc
    .array(fc.constantFrom('"', '\\', '{', '[', ',', ':', 'a', '\n'), { maxLength: 6 })
    .map((parts) => parts.join(''));
  fc.assert(
    fc.property(tricky, tricky, (key, value) => {
      const text = `{${JSON.stringify(`${key}-`)}: [${JSON.stringify(value)}, ${JSON.stringify(`\\${value}`)}], "last": 12345}`;
      const locator = createLocator(text);
      expect(text.slice(locator.offsetOf('/last', 'value'))).toBe('12345}');
      expect(text.slice(locator.offsetOf('/last', 'key'))).toBe('"last": 12345}');
    }),
  );
});
