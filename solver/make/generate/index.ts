export type { Generated, Rejection, SymmetryMeasure, ThemeMeasure } from './generated.ts';
export { createGenerator, type LevelGenerator } from './generator.ts';
export {
  type GeneratorOptions,
  INGREDIENTS,
  type Ingredient,
  SYMMETRIES,
  type SymmetryKind,
  THEME_NAMES,
  type ThemeName,
  USUAL_INGREDIENTS,
  type WantedDifficulty,
  type WantedSize,
} from './generator-spec.ts';
export { createPackJudge, type PackJudge, type PackOptions, type PackTheme, packLevel } from './pack.ts';
export { nearestDistances, type Variety, varietyOf } from './variety.ts';
