export { measureLevels } from './measure-levels.ts';
export type { MeasuredLevel, MeasureSettings, Players } from './measured-level.ts';
export { type CollectedPlays, collectPlays } from './plays/index.ts';
