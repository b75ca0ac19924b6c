export { exportTiled, formatTiled } from './export-tiled.ts';
export { formatTmx } from './format-tmx.ts';
export { type ImportTiledOptions, importTiled, isTiledMap } from './import-tiled.ts';
export type { TiledLayer, TiledMap, TiledObject, TiledProperty } from './map.ts';
