import { describe, expect, it } from 'vitest';
import { findWarnings } from '../../engine/index.ts';
import { entryName, objectName, readLevel, touchedName } from '../../schema/index.ts';

const messagesOf = (level: object): string[] => {
  const reading = readLevel(
    JSON.stringify({ version: 1, name: 'a', astronaut: { x: 0, y: 0 }, blackHole: { x: 90, y: 0 }, ...level }),
  );
  if (reading.ok) return findWarnings(reading.level, []).flatMap(({ message, hint }) => [message, hint]);
  return reading.problems.map(({ message }) => message);
};

describe('objects in words', () => {
  it('are counted from 1 if a level has several of a kind', () => {
    expect(objectName('asteroid', 3)).toBe('asteroid 4');
    expect(objectName('asteroid', 0, { hot: true })).toBe('hot asteroid 1');
    expect(objectName('blackHole', 0)).toBe('black hole');
    expect(entryName('novae', 1)).toBe('nova 2');
  });

  it('are called hot if only a hot asteroid ends a run', () => {
    expect(touchedName('asteroid', 1)).toBe('hot asteroid 2');
    expect(touchedName('alien', 0)).toBe('alien 1');
    expect(touchedName('blackHole', 0)).toBe('the black hole');
  });
});

describe('messages about a file', () => {
  it('name objects by kind and runs, counted from 1', () => {
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
        { name: 'third', holds: [[1.5, 2]] },
      ],
    });
    expect(messages).toEqual([
      'black hole, x: expected a number, found the text "far"',
      'asteroid 1, radius: expected a number, found the text "big"',
      'unknown key "hto" in asteroid 2: did you mean "hot"?',
      'the key "radius" is missing in asteroid 3',
      'run 1, hold 1: [4, 2] is reversed: the release must come after the press',
      'run 2, name: the name "asteroids[0]" already belongs to run 1',
      'run 2, hold 1, release: expected a number, found the text "late"',
      'run "third", hold 1, press: expected a whole number, found 1.5',
    ]);
  });

  it('contain no list index in warnings', () => {
    const rock = { x: 60, y: 0, radius: 16 };
    const words = messagesOf({
      asteroids: [rock, { ...rock, hot: true }],
      novae: [{ x: 0, y: 0, radius: 32 }],
      minerals: [
        { x: 60, y: 0 },
        { x: 5000, y: 0 },
      ],
    }).join('\n');
    expect(words).not.toMatch(/\[\d\]/);
    expect(words).toContain('asteroid 2 has the same centre as asteroid 1');
    expect(words).toContain('mineral 1 lies inside hot asteroid 2');
  });
});
