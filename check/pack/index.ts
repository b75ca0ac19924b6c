export {
  addChapter,
  addLevels,
  chaptersOf,
  inPackOrder,
  moveEntries,
  moveLevel,
  removeEntries,
  removeLevels,
  renameLevel,
  setChapter,
  shownEntries,
} from './arrange.ts';
export { PACK_FILE, type Pack, packedLevel, packScript, pageOf } from './pack.ts';
export { packProblems } from './pack-problems.ts';
export { EFFECT_NAMES, effectInWords, effectsToMeet, introductionsOf, JUMP, jumpsOf, type MetLevel } from './sequence.ts';
