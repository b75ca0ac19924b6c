export {
  addChapter,
  addLevels,
  moveEntries,
  moveLevel,
  removeEntries,
  removeLevels,
  renameLevel,
  setChapter,
  shownEntries,
} from './arrange.ts';
export { EFFECT_NAMES, effectInWords, effectsToMeet, introductionsOf, type MetLevel } from './introductions.ts';
export { JUMP, jumpsOf } from './jumps.ts';
export { chaptersOf, inPackOrder } from './order.ts';
export { PACK_FILE, type Pack, packedLevel, packScript, pageOf } from './pack.ts';
export { packProblems } from './pack-problems.ts';
