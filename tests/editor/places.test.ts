import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { lookAt, type Point, toScreen, type View } from '../../editor/canvas/view.ts';
import { levelsCalled, nearlyCalled } from '../../editor/features/places/find-level.ts';

const LEVELS = [
  { id: '07-slingshot', name: 'Slingshot' },
  { id: 'world-2/01-start', name: 'Start' },
  { id: 'world-3/01-start', name: 'Start' },
  { id: 'world-2/07-slingshot', name: 'The other one' },
  { id: 'broken', name: null },
];

describe('the level that a link names', () => {
  it.each([
    ['07-slingshot', ['07-slingshot']],
    ['07-slingshot.level.json', ['07-slingshot']],
    ['./levels/07-slingshot.level.json', ['07-slingshot']],
    ['levels/world-2/07-slingshot.level.json', ['world-2/07-slingshot']],
    ['levels\\world-2\\01-start.level.json', ['world-2/01-start']],
    ['/game/levels/world-2/01-start.level.json', ['world-2/01-start']],
    ['01-start', ['world-2/01-start', 'world-3/01-start']],
    ['Slingshot', ['07-slingshot']],
    ['slingshot', ['07-slingshot']],
    ['Start', ['world-2/01-start', 'world-3/01-start']],
    ['BROKEN.level.json', ['broken']],
    ['06-slingshot', []],
    ['', []],
    ['/', []],
    ['..', []],
    ['../../../etc/passwd', []],
    ['.level.json', []],
  ])('%s', (asked, ids) => {
    expect(levelsCalled(LEVELS, asked)).toEqual(ids);
  });

  it('is found by the path of its file from any folder above, if no other file is called so', () => {
    const id = fc
      .array(fc.stringMatching(/^[a-z][a-z0-9-]{0,6}$/), { minLength: 1, maxLength: 4 })
      .map((parts) => parts.join('/'));
    fc.assert(
      fc.property(fc.uniqueArray(id, { minLength: 1, maxLength: 8 }), fc.nat(), id, (ids, at, above) => {
        const levels = ids.map((one) => ({ id: one, name: null }));
        const wanted = ids[at % ids.length];
        expect(levelsCalled(levels, `${wanted}.level.json`)).toEqual([wanted]);
        const found = levelsCalled(levels, `${above}/${wanted}.level.json`);
        expect(
          found.every((one) => one === wanted || `${above}/${wanted}`.endsWith(one) || one.endsWith(`${above}/${wanted}`)),
        ).toBe(true);
        expect(found.length).toBeGreaterThan(0);
      }),
    );
  });

  it('is suggested if it is nearly called so', () => {
    expect(nearlyCalled(LEVELS, 'levels/06-slingshot.level.json')).toBe('07-slingshot');
    expect(nearlyCalled(LEVELS, 'The other on')).toBe('world-2/07-slingshot');
    expect(nearlyCalled(LEVELS, 'nothing like it')).toBeNull();
    expect(nearlyCalled([], 'a')).toBeNull();
  });
});

describe('a look at a place', () => {
  const size = { width: 800, height: 600 };
  const zoom = fc.double({ min: 0.02, max: 16, noNaN: true });
  const coordinate = fc.double({ min: -20_000, max: 20_000, noNaN: true });

  it('shows it clear of the edges, large enough to be made out, and moves no view that does', () => {
    fc.assert(
      fc.property(coordinate, coordinate, coordinate, coordinate, zoom, (x, y, placeX, placeY, level) => {
        const view: View = { x, y, zoom: level, ...size };
        const place: Point = { x: placeX, y: placeY };
        const seen = lookAt(view, place);
        const at = toScreen(seen, place);
        expect(at.x).toBeGreaterThan(47);
        expect(at.x).toBeLessThan(size.width - 47);
        expect(at.y).toBeGreaterThan(83);
        expect(at.y).toBeLessThan(size.height - 47);
        expect(seen.zoom).toBe(Math.max(0.5, level));
        expect(lookAt(seen, place)).toBe(seen);
      }),
    );
  });
});
