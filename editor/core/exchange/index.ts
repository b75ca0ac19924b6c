export { copyText } from './copy-text.ts';
export { type ExportedFile, levelFile, pictureSvg, toPng } from './export.ts';
export { type Importing, importLevels, plainName, slugOf } from './import-levels.ts';
export { type Linking, LONGEST_LINK, levelOf, linkTo } from './link.ts';
export { chooseFiles, downloadFile, keepFile, unlessClosed } from './local-files.ts';
export { playPageOf } from './play-page.ts';
export { fetchGame, singlePage } from './single-page.ts';
