import { InvalidArgumentError } from 'commander';
import { type Hold, readRunText } from '../schema/index.ts';

const EXPECTED = 'expected holds in ticks of 1/60 s, each as press-release, in order of time, like 12-96,130-188; or none';

/** Characters of the value that are shown, and how many of them stand before the place. */
const SHOWN = 120;
const BEFORE = 60;

/**
 * Reads the value of `--holds`: `12-96,130-188` or `none`, or a run as text with notes, which are left out.
 * @throws InvalidArgumentError saying what was expected, with a caret under the place
 */
export function parseHolds(text: string): Hold[] {
  const reading = readRunText(text, { isStrict: true });
  if (reading.ok) return [...reading.holds];
  const { offset, message } = reading;
  // of a very long value, only the part around the place is shown
  const from = Math.max(0, offset - BEFORE);
  const shown = text.slice(from, from + SHOWN).replace(/\s/g, ' ');
  throw new InvalidArgumentError(`${EXPECTED}\n  ${shown}\n  ${' '.repeat(offset - from)}^ ${message}`);
}
