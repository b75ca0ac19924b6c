import { InvalidArgumentError, Option } from 'commander';
import { type EditorPlace, placeFragment } from '../../schema/index.ts';
import type { CheckedLevel } from '../check/index.ts';
import { entryName } from '../io/index.ts';
import { shellPath } from '../terminal/index.ts';

/** Where to look at the failure of a level. */
interface FailingPlace {
  /** The command that opens the editor there. */
  readonly command: string;
  /** The address that opens the editor there; null if no address of a page is known. */
  readonly link: string | null;
  /** The tick at which the run that fails ends; null if no run fails. */
  readonly tick: number | null;
}

/** Makes a link to a place in the editor. */
export type EditorLink = (place: EditorPlace) => string;

/** Makes links to a page of the editor; null if no address of one is known. */
export const editorLinkTo = (url = ''): EditorLink | null => (url === '' ? null : (place) => `${url}#${placeFragment(place)}`);

/** Whether a level needs attention. */
export const isFailing = ({ verdict, problems }: CheckedLevel): boolean =>
  verdict !== 'completable' || problems.some(({ severity }) => severity === 'error');

/** Whether the editor can open a file: it lists no others, and does not look into packs. */
const isEditable = ({ file, unreadable }: CheckedLevel): boolean =>
  !unreadable && /[^\\/]\.level\.json$/.test(file) && entryName(file) === null;

/**
 * Where to look at the failure of a level; null if the level does not fail, or the editor can't open its file.
 * @param linkTo null if no address of a page of the editor is known
 */
export function failureOf(level: CheckedLevel, linkTo: EditorLink | null): FailingPlace | null {
  if (!isFailing(level) || !isEditable(level)) return null;
  const { file, run } = level;
  const [tick, name] = run === null || run.outcome === 'completed' ? [null, null] : [run.tick, run.name];
  const command = `gq edit --open ${shellPath(tick === null ? file : `${file}:${tick}`)}`;
  const link = linkTo === null ? null : linkTo({ level: linkedFile(file), run: name, tick });
  return { command, link, tick };
}

/** A file as a link names it: readers know the folders of the project, but not those of the machine that made the report. */
function linkedFile(file: string): string {
  const parts = file.split(/[\\/]+/);
  const isAbsolute = parts[0] === '' || /^[a-z]:$/i.test(parts[0]);
  return isAbsolute ? parts[parts.length - 1] : parts.filter((part) => part !== '.' && part !== '..').join('/');
}

/** What a person can do to look at a failure: `gq edit --open FILE:TICK, or LINK`. */
export const placeInWords = ({ command, link }: FailingPlace): string => (link === null ? command : `${command}, or ${link}`);

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
