import { type LevelFile, OBJECT_LISTS } from '../../../schema/index.ts';

/** Whether two files have the same objects and rules, so that every run plays alike in them. What they share is compared at once. */
export function playsAlike(a: LevelFile, b: LevelFile): boolean {
  if (a.range !== b.range || a.recoil !== b.recoil || a.astronaut !== b.astronaut || a.blackHole !== b.blackHole) return false;
  return OBJECT_LISTS.every((list) => a[list] === b[list]);
}
