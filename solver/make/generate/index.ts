export type { Generated, Rejection, SymmetryMeasure, ThemeMeasure } from './generated.ts';
export { createGenerator, type LevelGenerator } from './generator.ts';
export {
  type GeneratorOptions,
  INGREDIENTS,
  type Ingredient,
  USUAL_INGREDIENTS,
  type WantedDifficulty,
  type WantedSize,
} from './generator-spec.ts';
export { createPackJudge, type PackJudge, type PackOptions, type PackTheme, packLevel } from './pack.ts';
export { SYMMETRIES, type SymmetryKind, THEME_NAMES, type ThemeName } from './theme-name.ts';
export { nearestDistances, type Variety, varietyOf } from './variety.ts';
