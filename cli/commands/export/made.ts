import { basename, extname, join } from 'node:path';
import {
  exportOriginal,
  exportTiled,
  formatOriginal,
  formatTiled,
  formatTmx,
  type Level,
  type LevelDocument,
  type Problem,
  type TitledOriginal,
} from '../../../schema/index.ts';
import { Failure } from '../../terminal/index.ts';

/** A level that was read. */
export interface ReadFile {
  readonly file: string;
  readonly level: Level;
  readonly source: LevelDocument;
}

/** A file that cannot be exported, and why. */
export interface Refused {
  readonly file: string;
  readonly problems: readonly Problem[];
  /** The text of the file. */
  readonly text: string;
}

/** Files to write, and what they do not say. */
export interface Made {
  readonly files: readonly {
    /** Its name; `-` for standard output. */
    readonly file: string;
    /** The level files that are in it. */
    readonly levels: readonly string[];
    readonly text: string;
  }[];
  readonly warnings: readonly { readonly file: string; readonly message: string }[];
}

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

interface TiledOptions {
  readonly output?: string;
  readonly out?: string;
}

const stemOf = (file: string): string => basename(file.replaceAll('\\', '/')).replace(/\.level\.json$|\.json$/, '');

/** A map for each level: in a folder, or one in a file. */
export function toTiled(levels: readonly ReadFile[], { output = '-', out }: TiledOptions): Made {
  if (out === undefined && levels.length > 1) {
    const found = `${levels.length} levels`;
    throw new Failure(`--to tiled: expected one level, since a map holds one, found ${found}; --out DIR writes a map for each`);
  }
  const isXml = ['.tmx', '.xml'].includes(extname(output).toLowerCase());
  const taken = new Map<string, string>();
  const files = levels.map(({ file: level, source }) => {
    const file = out === undefined ? output : join(out, `${stemOf(level)}.tmj`);
    const other = taken.get(file);
    if (other !== undefined)
      throw new Failure(`${file}: expected one level of this name, found ${other} and ${level}; rename one, or export it alone`);
    taken.set(file, level);
    const map = exportTiled(source.file);
    return { file, levels: [level], text: isXml ? formatTmx(map) : formatTiled(map) };
  });
  return { files, warnings: [] };
}
