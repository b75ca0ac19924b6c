import { resolve } from 'node:path';
import { describe, expect, it } from 'vitest';
import { filesIn, ROOMS } from '../../bench/mutation/rooms.ts';

const PROJECT = resolve(import.meta.dirname, '../..');

describe('rooms of mutants', () => {
  it.each(Object.entries(ROOMS))('%s has sources and tests, all of which exist', (_, { sources, tests }) => {
    expect(filesIn(PROJECT, sources, '.ts').length).toBeGreaterThan(0);
    expect(filesIn(PROJECT, tests, '.test.ts').length).toBeGreaterThan(0);
  });

  it('a place that was renamed is named', () => {
    expect(() => filesIn(PROJECT, ['tests/editor/gone.test.ts'], '.test.ts')).toThrow(
      'name tests/editor/gone.test.ts, which does not exist',
    );
  });
});
