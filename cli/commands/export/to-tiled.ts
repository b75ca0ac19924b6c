import { basename, extname, join } from 'node:path';
import { exportTiled, formatTiled, formatTmx } from '../../../schema/index.ts';
import { Failure } from '../../io/index.ts';
import type { Made, ReadFile } from './made.ts';

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
