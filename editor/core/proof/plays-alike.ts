import { type Level, type LevelFile, OBJECT_LISTS, RULE_NAMES } from '../../../schema/index.ts';

/** A level and its file. */
export interface PlayedFile {
  readonly file: LevelFile;
  readonly level: Pick<Level, 'rules'>;
}

/**
 * Whether two levels have the same objects and rules, so that every run is the same in both. Objects that the files share are
 * compared by reference.
 */
export function playsAlike({ file: a, level: one }: PlayedFile, { file: b, level: other }: PlayedFile): boolean {
  if (a.range !== b.range || a.recoil !== b.recoil || a.astronaut !== b.astronaut || a.blackHole !== b.blackHole) return false;
  if (RULE_NAMES.some((name) => one.rules?.[name] !== other.rules?.[name])) return false;
  return OBJECT_LISTS.every((list) => a[list] === b[list]);
}
