import { inPackOrder } from '../../check/pack/index.ts';
import { levelsOfPack } from '../../schema/index.ts';
import { levelIdOf } from '../found-pack.ts';
import { sortedByPlay } from '../order-of-play.ts';
import { readPackFile } from './read-pack-file.ts';

/**
 * The level files of a folder in the order of its pack: those that it lists first, the others after them by name, with numbers by
 * their value. A pack that is not valid says nothing.
 */
export function orderFiles(files: readonly string[], folder: string, packFile: string): string[] {
  const read = readPackFile(packFile);
  if ('unreadable' in read || !read.reading.ok) return [...files];
  const idOf = (file: string): string => levelIdOf(folder, file);
  return inPackOrder(sortedByPlay(files, idOf), idOf, levelsOfPack(read.reading.pack));
}
