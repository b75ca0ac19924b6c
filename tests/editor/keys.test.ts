import { describe, expect, it } from 'vitest';
import { isModKey } from '../../editor/core/commands/index.ts';

// Lists duplicate their row at Ctrl+D. Ctrl+Shift+D is the key of a command, “Repeat”, and went to the list as well.

const pressed = (key: string, ...held: readonly ('ctrlKey' | 'metaKey' | 'shiftKey' | 'altKey')[]) => ({
  key,
  ...{ ctrlKey: false, metaKey: false, shiftKey: false, altKey: false },
  ...Object.fromEntries(held.map((name) => [name, true])),
});

describe('a key with Ctrl or ⌘', () => {
  it.each([
    ['Ctrl+D', pressed('d', 'ctrlKey'), true],
    ['⌘D', pressed('d', 'metaKey'), true],
    ['Ctrl+D with caps lock', pressed('D', 'ctrlKey'), true],
    ['D alone', pressed('d'), false],
    ['Ctrl+Shift+D', pressed('D', 'ctrlKey', 'shiftKey'), false],
    ['⌘⇧D', pressed('d', 'metaKey', 'shiftKey'), false],
    ['Ctrl+Alt+D', pressed('d', 'ctrlKey', 'altKey'), false],
    ['another key', pressed('e', 'ctrlKey'), false],
  ])('%s', (_, event, is) => {
    expect(isModKey(event, 'd')).toBe(is);
  });
});
