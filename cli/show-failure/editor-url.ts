import { InvalidArgumentError, Option } from 'commander';

/** The address of an editor's page that is on a host; reports link to it. */
export const editorUrlOption = (): Option =>
  new Option('--editor-url <url>', 'address of a page of the editor, to which reports link')
    .env('GQ_EDITOR_URL')
    .argParser(parseEditorUrl);

/** @returns '' for an empty text: CI systems set variables that have no value */
function parseEditorUrl(text: string): string {
  if (text.trim() === '') return '';
  const url = URL.canParse(text) ? new URL(text) : null;
  if (url === null || !['https:', 'http:'].includes(url.protocol)) {
    throw new InvalidArgumentError('expected an address that begins with https:// or http://, like https://example.org/editor/');
  }
  // reports are read by others
  if (url.username !== '' || url.password !== '' || /(?:^#|&)token=/.test(url.hash)) {
    throw new InvalidArgumentError(
      'expected an address without a password or a token, which every reader of the report would see',
    );
  }
  url.hash = '';
  return url.href.replace(/#$/, '');
}
