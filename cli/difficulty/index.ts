export { difficultyJson, measuredJson } from './json.ts';
export { measureAgain, measureContent } from './measure-level.ts';
export {
  curvesInWords,
  curvesOf,
  type MeasuredLevel,
  type MeasureSettings,
  measureLevels,
  measureSettings,
  unreadable,
} from './measured-level.ts';
export { causeInWords, refusedPlays } from './players-pretty.ts';
export { type CollectedPlays, collectPlays } from './plays/index.ts';
export { difficultyPretty } from './pretty.ts';
