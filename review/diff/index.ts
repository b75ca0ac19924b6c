export { applyDiff } from './apply-diff.ts';
export type { Change } from './change.ts';
export { diffLevels, marksOf } from './diff-levels.ts';
export { levelInLines } from './level-lines.ts';
export {
  assessLevel,
  playAlike,
  renamedStanding,
  type StandingRun,
  type VersionStanding,
} from './standing.ts';
export { takeBack } from './take-back.ts';
export { changesInWords, effectsInWords, standingInWords } from './words/index.ts';
