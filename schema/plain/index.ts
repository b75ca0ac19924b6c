// Reading levels in a game. The reader of the schema needs zod, which is larger than the engine, and explains every mistake to
// the author of a level. This one checks against a table that is made of the same schema (plain-shape.ts), so that the two can
// not differ in what is valid, and bundles carry neither zod nor the words of the tables of kinds and rules.
export { fitsLevel } from './fits.ts';
export { type PlainLevelReading, type ReadPlainLevelOptions, readPlainLevel } from './read-plain-level.ts';
export type { Shape } from './shape.ts';
