export {
  createFile,
  createPrivateFile,
  isTaken,
  LineWriter,
  makeFolders,
  moveFile,
  renamePatiently,
  replaceFile,
  replaceSpareFile,
  tryFolder,
  UNFINISHED,
} from './disk.ts';
export { FETCH_MORE, Git, repositoryOf, tryGit } from './git.ts';
export {
  type FoundPack,
  inOrderOfPlay,
  isPackFile,
  levelIdOf,
  NOT_A_LEVEL,
  nameOfFile,
  packFileOf,
  sortedByPlay,
} from './level-names.ts';
export {
  type Batch,
  type Contents,
  type Entry,
  entriesOf,
  entryName,
  firstPack,
  packFormat,
  readSet,
  sizeOf,
} from './packs/index.ts';
export { openPool, runInParts, runInPool, startThread, type Thread } from './pool.ts';
export { isStream, readBytes, readStdin, STDIN, STDIN_NAME, siblingHint, stdinName } from './read.ts';
export { NotAFile, openRegularFile, readBeyond, readRegularFile } from './regular-file.ts';
export {
  expectOutput,
  type Inputs,
  levelsRead,
  Outputs,
  realTarget,
  standing,
  whyNotWritable,
  whyUnreachable,
} from './replaceable.ts';
export { filesBelow, isShown, once, onceBy, readBuilt, statOrError, walk } from './walk.ts';
export {
  differing,
  type FileStatus,
  type PlannedFile,
  planFile,
  removeFolders,
  writeAll,
  writeResultFiles,
  writeWhole,
} from './write.ts';
