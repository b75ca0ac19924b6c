import { InvalidArgumentError } from 'commander';
import type { Hold } from '../schema/index.ts';

const MAX_TICK = 216_000;
const EXPECTED = 'expected holds in ticks of 1/60 s, each as press-release, in order of time, like 12-96,130-188; or none';

/**
 * Reads the value of `--holds`: `12-96,130-188` or `none`.
 * @throws InvalidArgumentError saying what was expected, with a caret under the place
 */
export function parseHolds(text: string): Hold[] {
  if (text.trim() === 'none') return [];
  const holds: [number, number][] = [];
  let at = 0;

  const fail = (place: number, why: string): never => {
    // of a very long value, only the part around the place is shown
    const from = Math.max(0, place - 60);
    const shown = text.slice(from, from + 120).replace(/\s/g, ' ');
    throw new InvalidArgumentError(`${EXPECTED}\n  ${shown}\n  ${' '.repeat(place - from)}^ ${why}`);
  };
  const skipSpace = () => {
    while (text[at] === ' ') at++;
  };
  const readTick = (what: string): number => {
    skipSpace();
    const digits = /^\d+/.exec(text.slice(at, at + 32))?.[0];
    if (digits === undefined) {
      const found = at < text.length ? `found ${JSON.stringify(text[at])}` : 'found the end';
      return fail(at, `expected the tick of a ${what} here (a whole number from 0 to ${MAX_TICK}), ${found}`);
    }
    const tick = Number(digits);
    if (tick > MAX_TICK) fail(at, `tick ${digits} is later than ${MAX_TICK}, which is an hour`);
    at += digits.length;
    skipSpace();
    return tick;
  };

  for (;;) {
    skipSpace();
    const start = at;
    const press = readTick('press');
    if (text[at] !== '-') fail(at, `expected "-" and the tick of the release after ${press}`);
    at++;
    const release = readTick('release');
    if (release <= press) fail(start, `the release (${release}) must be later than the press (${press})`);
    const last = holds.at(-1);
    if (last !== undefined && press < last[1]) {
      fail(start, `this hold begins at ${press}, before the previous one ends (${last[1]})`);
    }
    holds.push([press, release]);
    if (at === text.length) return holds;
    if (text[at] !== ',') fail(at, 'expected "," and another hold, or the end');
    at++;
  }
}
