import fc from 'fast-check';
import { expect, it } from 'vitest';
import { isFrameDue } from '../../editor/canvas/picture.ts';

const picture = (calm: boolean) => ({ file: {}, pose: {}, onion: null as object | null, moment: 0, calm });

it('a frame is drawn at once if any part has changed, and skipped for a moment if none has', () => {
  const changes = fc.constantFrom({}, { file: {} }, { pose: {} }, { onion: {} }, { moment: 0.5 });
  fc.assert(
    fc.property(fc.boolean(), changes, fc.double({ min: 0, max: 29, noNaN: true }), (calm, change, since) => {
      const last = picture(calm);
      expect(isFrameDue(last, { ...last, ...change }, since)).toBe(Object.keys(change).length > 0);
    }),
  );
});

it('decorations move about thirty times a second; where they stand still, a frame a second is drawn', () => {
  const [lively, calm] = [picture(false), picture(true)];
  expect([29, 30, 31].map((since) => isFrameDue(lively, lively, since))).toEqual([false, true, true]);
  expect([30, 999, 1000].map((since) => isFrameDue(calm, calm, since))).toEqual([false, false, true]);
  // once the user wants motion again, it does not wait for the second to be over
  expect(isFrameDue(calm, lively, 1)).toBe(true);
});

it('a clock that was set back does not stop the picture', () => {
  const last = picture(true);
  expect(isFrameDue(last, last, -5)).toBe(true);
});
