export {
  chooseFiles,
  copyText,
  downloadFile,
  type ExportedFile,
  keepFile,
  levelFile,
  pictureSvg,
  toPng,
  unlessClosed,
} from './export.ts';
export { type Importing, importLevels, plainName, slugOf } from './import-levels.ts';
export { type Linking, LONGEST_LINK, levelOf, linkTo, playPageOf } from './link.ts';
export { fetchGame, singlePage } from './single-page.ts';
