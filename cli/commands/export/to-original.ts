import { basename, extname } from 'node:path';
import { exportOriginal, formatOriginal, type TitledOriginal } from '../../../schema/index.ts';
import { Failure } from '../../io/index.ts';
import type { Made, ReadFile, Refused } from './made.ts';

export interface OriginalOptions {
  readonly output?: string;
  readonly module?: true;
  readonly byNumber?: true;
  readonly drop?: true;
}

/** The largest number of a level: more placeholders before it are a mistake. */
const LARGEST_NUMBER = 9999;

const isModule = ({ output = '', module }: OriginalOptions): boolean =>
  module === true || ['.js', '.cjs'].includes(extname(output).toLowerCase());

/** One file with all levels, or the levels that cannot be said in it. */
export function toOriginal(levels: readonly ReadFile[], options: OriginalOptions): Made | { readonly refused: Refused[] } {
  const places = options.byNumber ? placesByNumber(levels) : levels.map((_, i) => i);
  const exported = levels.map(({ file, level, source }) => ({ file, source, ...exportOriginal(level, source) }));
  const refused = exported.filter((one) => one.refused.length > 0);
  if (refused.length > 0 && !options.drop) {
    return { refused: refused.map(({ file, refused, source }) => ({ file, problems: refused, text: source.text })) };
  }
  const list: TitledOriginal[] = Array.from({ length: Math.max(...places) + 1 }, () => ({ title: '', object: {} }));
  for (const [i, { object, source }] of exported.entries()) {
    list[places[i]] = { title: `Level ${places[i]}: ${source.file.name}`, object };
  }
  const warnings = exported.flatMap(({ file, refused, differences, lost }) => {
    const left = refused.map(({ message }) => `left out: ${message}`);
    return [...left, ...differences, ...lost].map((message) => ({ file, message }));
  });
  const text = formatOriginal(list, isModule(options) ? 'module' : 'json');
  return { files: [{ file: options.output ?? '-', levels: levels.map(({ file }) => file), text }], warnings };
}

/** The places that the names of files give: `level-07` and `07-over-the-edge` are 7. */
function placesByNumber(levels: readonly ReadFile[]): number[] {
  const owners = new Map<number, string>();
  return levels.map(({ file }) => {
    const digits = /^(?:level-)?(\d+)/.exec(basename(file.replaceAll('\\', '/')))?.[1];
    const number = Number(digits ?? Number.NaN);
    if (!(number <= LARGEST_NUMBER)) {
      const found = digits === undefined ? 'none' : digits;
      throw new Failure(
        `--by-number: ${file}: expected a number up to ${LARGEST_NUMBER} at the start of its name, found ${found}`,
      );
    }
    const other = owners.get(number);
    if (other !== undefined)
      throw new Failure(`--by-number: expected one level ${number}, found ${other} and ${file}; rename one`);
    owners.set(number, file);
    return number;
  });
}
