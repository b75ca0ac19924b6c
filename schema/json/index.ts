// From the bytes of a file to a JSON value with places, or what is wrong with it, and what else the file may be.

export { isUtf16, otherEditor, xmlRoot } from './foreign-file.ts';
export { LFS, MERGE_MARKER, mergeMarkers, pointerFile } from './git-leftovers.ts';
export { codeFrame, createPlaceFinder, type Locator, type TextPlace } from './locate.ts';
export { strictJson } from './mistakes.ts';
export { type JsonReading, readJson, toProblems } from './read-json.ts';
export { type Mistake, scanJson } from './scan.ts';
export { decodeUtf8 } from './utf8.ts';
export * from './values.ts';
