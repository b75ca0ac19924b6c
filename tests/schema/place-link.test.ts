import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { placeFragment, placeIn } from '../../schema/index.ts';

const name = fc.string({ unit: 'grapheme', minLength: 1, maxLength: 60 });
const place = fc.record({
  level: fc.oneof(
    fc.stringMatching(/^[\w-]{1,80}$/),
    name,
    name.map((text) => `levels/${text}.level.json`),
  ),
  run: fc.option(name),
  tick: fc.option(fc.nat({ max: 999_999_999 })),
});

describe('a link to a place', () => {
  it('reads back as it was written, beside other parts of the fragment', () => {
    fc.assert(
      fc.property(place, fc.boolean(), (asked, withToken) => {
        const fragment = placeFragment(asked);
        expect(fragment).toMatch(/^[\w\-.~!*'()%/=&]+$/);
        expect(placeIn(`#${withToken ? 'token=abc&' : ''}${fragment}`)).toEqual({ place: asked, problem: null });
      }),
    );
  });

  it('looks like an address that a person can write', () => {
    expect(placeFragment({ level: 'levels/07 a.level.json', run: 'solution', tick: 412 })).toBe(
      'level=levels/07%20a.level.json&tick=412&run=solution',
    );
    expect(placeFragment({ level: '07', run: null, tick: null })).toBe('level=07');
  });

  it.each([
    ['', null],
    ['#', null],
    ['#token=abc', null],
    ['#level=', null],
    ['#tick=3', null],
    // a level inside a link
    [`#level=${'aB3_-'.repeat(40)}`, null],
    [`#level=${'aB3_-'.repeat(40)}&tick=1`, { level: 'aB3_-'.repeat(40), run: null, tick: 1 }],
    ['#level=07&run=&tick=', { level: '07', run: null, tick: null }],
    ['#level=100%&tick=0', { level: '100%', run: null, tick: 0 }],
    ['#level=07&level=08', { level: '07', run: null, tick: null }],
  ])('%s names %j', (fragment, asked) => {
    expect(placeIn(fragment)?.place ?? null).toEqual(asked);
  });

  it.each(['-1', '1.5', '1e9', '0x10', 'NaN', ' 3', '9999999999', '%00', '%', '<script>'])('reports the tick %s', (tick) => {
    const reading = placeIn(`#level=07&tick=${tick}`);
    expect(reading?.place).toEqual({ level: '07', run: null, tick: null });
    expect(reading?.problem).toMatch(/^expected a tick like 412, found "/);
  });

  it('never fails, whatever a level or a run is called', () => {
    const any = fc.oneof(fc.string({ unit: 'binary' }), fc.constantFrom('\ud800', 'a\udc00\ud800b'));
    fc.assert(
      fc.property(any, any, (level, run) => {
        expect(placeFragment({ level, run, tick: null })).toMatch(/^[\w\-.~!*'()%/=&]*$/);
      }),
    );
  });

  it('never fails, whatever the fragment is', () => {
    fc.assert(
      fc.property(fc.string(), fc.string(), fc.string(), (level, run, tick) => {
        const reading = placeIn(`#level=${level}&run=${run}&tick=${tick}`);
        const found = reading?.place.tick ?? 0;
        expect(Number.isSafeInteger(found) && found >= 0).toBe(true);
      }),
    );
  });
});
