export { difficultyJson, measuredJson } from './json.ts';
export { measureAgain, measureContent } from './measure-level.ts';
export { measureLevels, measureSettings, type MeasuredLevel, type MeasureSettings, unreadable, curvesInWords, curvesOf } from './measured-level.ts';
export { causeInWords, refusedPlays } from './players-pretty.ts';
export { type CollectedPlays, collectPlays } from './plays/index.ts';
export { difficultyPretty } from './pretty.ts';
