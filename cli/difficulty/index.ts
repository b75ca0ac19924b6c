export { difficultyJson, measuredJson } from './json.ts';
export { measureAgain, measureContent } from './measure-level.ts';
export { measureLevels } from './measure-levels.ts';
export { measureSettings } from './measure-settings.ts';
export { type MeasuredLevel, type MeasureSettings, unreadable } from './measured-level.ts';
export { curvesInWords, curvesOf } from './pack-curve.ts';
export { causeInWords, refusedPlays } from './players-pretty.ts';
export { type CollectedPlays, collectPlays } from './plays/index.ts';
export { difficultyPretty } from './pretty.ts';
