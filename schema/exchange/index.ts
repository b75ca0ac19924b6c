// Levels from and to other programs.
export * from './export-original.ts';
export { type ImportedLevel, type ImportReading, importOriginal } from './import-original.ts';
export * from './tiled/index.ts';
