// From the bytes of a file to a JSON value with places, or what is wrong with it, and what else the file may be.
export { codeFrame } from './code-frame.ts';
export { isUtf16, otherEditor, xmlRoot } from './foreign-file.ts';
export { createPlaceFinder, type Locator, type TextPlace } from './locate.ts';
export { MERGE_MARKER, mergeMarkers } from './merge-markers.ts';
export { strictJson } from './mistakes.ts';
export { LFS, pointerFile } from './pointer-file.ts';
export { type JsonReading, readJson, toProblems } from './read-json.ts';
export { type Mistake, scanJson } from './scan.ts';
export { decodeUtf8 } from './utf8.ts';
export { isSame, withoutExtensions } from './values.ts';
