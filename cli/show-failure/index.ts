export { editorUrlOption } from './editor-url.ts';
export { type EditorLink, editorLinkTo, type FailingPlace, failureOf, isFailing, placeInWords } from './failing-place.ts';
