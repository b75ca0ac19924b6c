export type { Generated } from './generated.ts';
export { createGenerator, type LevelGenerator } from './generator.ts';
export type { GeneratorOptions, Ingredient, WantedDifficulty, WantedSize } from './generator-spec.ts';
