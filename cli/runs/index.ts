import { InvalidArgumentError } from 'commander';
import { type Hold, type Level, readRunText } from '../../schema/index.ts';
import { didYouMean, Failure } from '../terminal/index.ts';

export interface ChosenRun {
  readonly name: string;
  readonly holds: readonly Hold[];
}

/**
 * The run that `--run` or `--holds` selects; by default the level's first.
 * @throws Failure if there is no such run
 */
export function chooseRun(
  file: string,
  level: Level,
  options: { readonly run?: string; readonly holds?: readonly Hold[] },
): ChosenRun {
  if (options.run !== undefined && options.holds !== undefined) {
    throw new Failure('--run and --holds cannot be combined: a run has its own holds; give one of the two');
  }
  if (options.holds !== undefined)
    return { name: options.holds.length === 0 ? 'she drifts' : 'holds from the command line', holds: options.holds };
  const names = level.runs.map((run) => run.name);
  if (options.run !== undefined) {
    const found = level.runs.find((run) => run.name === options.run);
    if (found !== undefined) return { name: `run ${JSON.stringify(found.name)}`, holds: found.holds };
    const has = names.length === 0 ? 'the level has no runs' : `it has ${names.map((n) => JSON.stringify(n)).join(', ')}`;
    throw new Failure(`${file}: no run is named ${JSON.stringify(options.run)}${didYouMean(options.run, names)}; ${has}`);
  }
  const first = level.runs[0];
  if (first === undefined)
    throw new Failure(`${file}: the level has no run; give holds with --holds 12-96,130-188, or --holds none to let her drift`);
  return { name: `run ${JSON.stringify(first.name)}`, holds: first.holds };
}

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
