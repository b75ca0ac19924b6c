export { measureLevels } from './measure-levels.ts';
export type { MeasuredLevel, MeasureSettings } from './measured-level.ts';
