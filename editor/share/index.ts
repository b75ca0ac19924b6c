export { copyText } from './copy-text.ts';
export { type ExportedFile, levelFile, pictureSvg, toPng } from './export.ts';
export { enteringFolder, leavingFolder } from './folder-rules.ts';
export { type Importing, importLevels, slugOf } from './import-levels.ts';
export { type Linking, LONGEST_LINK, levelOf, linkTo } from './link.ts';
export { chooseFiles, keepFile } from './local-files.ts';
