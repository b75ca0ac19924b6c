// Levels from and to other programs.
export {
  exportOriginal,
  formatOriginal,
  type OriginalExport,
  type OriginalLevel,
  type TitledOriginal,
} from './export-original.ts';
export { type ImportedLevel, type ImportReading, importOriginal } from './import-original.ts';
export {
  exportTiled,
  formatTiled,
  formatTmx,
  type ImportTiledOptions,
  importTiled,
  isTiledMap,
  type TiledLayer,
  type TiledMap,
  type TiledObject,
  type TiledProperty,
} from './tiled/index.ts';
