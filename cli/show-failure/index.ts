export { editorUrlOption } from './editor-url.ts';
export { type EditorLink, editorLinkTo, failureOf, placeInWords } from './failing-place.ts';
