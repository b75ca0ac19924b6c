export { editorUrlOption } from './editor-url.ts';
export { type EditorLink, editorLinkTo, failureOf, isFailing, placeInWords } from './failing-place.ts';
