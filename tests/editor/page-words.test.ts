import { describe, expect, it } from 'vitest';
import { inPageWords } from '../../editor/document/index.ts';
import { findWarnings } from '../../engine/index.ts';
import { readLevel } from '../../schema/index.ts';

const messagesOf = (level: object): string[] => {
  const reading = readLevel(
    JSON.stringify({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 90, y: 0 }, ...level }),
  );
  if (reading.ok) return findWarnings(reading.level, []).flatMap(({ message, hint }) => [message, hint]);
  return reading.problems.map(({ message }) => message);
};

describe('messages about a file in the words of the page', () => {
  it('name objects and runs by what they are, counted from 1', () => {
    const messages = messagesOf({
      asteroids: [
        { x: 0, y: 0, radius: 'big' },
        { x: 0, y: 0, radius: 1, hto: true },
        { x: 1, y: 1 },
      ],
      blackHole: { x: 'far', y: 0 },
      runs: [
        { name: 'asteroids[0]', holds: [[4, 2]] },
        { name: 'asteroids[0]', holds: [[1, 'late']] },
      ],
    }).map(inPageWords);
    expect(messages).toEqual([
      'black hole, x: expected a number, found the text "far"',
      'asteroid 1, radius: expected a number, found the text "big"',
      'unknown key "hto" in asteroid 2: did you mean "hot"?',
      'the key "radius" is missing in asteroid 3',
      'run 1, hold 1: the hold [4, 2] is reversed: release must come after press',
      'run 2, name: the name "asteroids[0]" belongs to run 1 already',
      'run 2, hold 1, release: expected a number, found the text "late"',
    ]);
  });

  it('leave no index of a list in warnings', () => {
    const rock = { x: 60, y: 0, radius: 16 };
    const messages = messagesOf({
      asteroids: [rock, { ...rock, hot: true }],
      novae: [{ x: 0, y: 0, radius: 32 }],
      minerals: [
        { x: 60, y: 0 },
        { x: 5000, y: 0 },
      ],
    });
    const words = messages.map(inPageWords);
    expect(messages.join()).toMatch(/\[\d\]/);
    expect(words.join('\n')).not.toMatch(/\[\d\]/);
    expect(words.join('\n')).toContain('asteroid 2 has the same centre as asteroid 1');
  });
});
