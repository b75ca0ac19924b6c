export * from './export.ts';
export { type Importing, importLevels } from './import-levels.ts';
export { type Linking, LONGEST_LINK, levelOf, linkTo, playPageOf } from './link.ts';
export { fetchGame, pictureSvg, singlePage, toPng } from './made-files.ts';
