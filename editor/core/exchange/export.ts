import { fileOpen, fileSave } from 'browser-fs-access';
import { formatLevel, LEVEL_ID_PART, type LevelFile } from '../../../schema/index.ts';
import type { Notices } from '../notices/index.ts';

/** A file to save. */
export interface ExportedFile {
  readonly name: string;
  readonly blob: Blob;
}

/** Letters that Unicode does not decompose into a Latin letter and a mark, and umlauts in their usual transcription. */
const LETTERS: Readonly<Record<string, string>> = {
  ...{ ä: 'ae', ö: 'oe', ü: 'ue', ß: 'ss', æ: 'ae', œ: 'oe', ø: 'oe', þ: 'th', ð: 'd', đ: 'd', ħ: 'h' },
  ...{ ı: 'i', ł: 'l', ŋ: 'ng', ŧ: 't', ĸ: 'k', ſ: 's', ƒ: 'f' },
};

/** A text as letters a-z, digits and hyphens: `Sling Shot!` becomes `sling-shot`, `Böse` `boese`, `Café` `cafe`; '' if it has none. */
export const plainName = (text: string): string =>
  text
    .toLowerCase()
    .normalize('NFC')
    .replace(/[^\p{ASCII}]/gu, (letter) => LETTERS[letter] ?? letter)
    // accents are dropped; any other character that is not a letter separates words
    .normalize('NFKD')
    .replace(/\p{Mn}+/gu, '')
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 60)
    .replace(/-+$/, '');

/** `07 Sling Shot!.level.json` becomes `07-sling-shot`; a name without a Latin letter or digit becomes `level`. */
export function slugOf(fileName: string): string {
  const slug = plainName(fileName.replace(/(\.level)?\.json$/i, ''));
  if (slug === '') return 'level';
  // some names are reserved for devices on some systems
  return LEVEL_ID_PART.test(slug) ? slug : `level-${slug}`;
}

/** The level as a file for `gq`. @param id of the level */
export function levelFile(id: string, file: LevelFile): ExportedFile {
  const name = `${id.split('/').at(-1)}.level.json`;
  return { name, blob: new Blob([formatLevel(file)], { type: 'application/json' }) };
}

/** What a dialog of the browser gives; null if the user closed it. */
export async function unlessClosed<T>(dialog: Promise<T>): Promise<T | null> {
  try {
    return await dialog;
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return null;
    throw error;
  }
}

/** Lets the user choose level files. @returns null if none were chosen */
export const chooseFiles = (): Promise<readonly File[] | null> =>
  unlessClosed(fileOpen({ description: 'levels', mimeTypes: ['application/json'], extensions: ['.json'], multiple: true }));

/** Saves a file for the user, by a dialog or as a download. @returns whether it was saved */
export async function keepFile({ name, blob }: ExportedFile): Promise<boolean> {
  const saving = fileSave(blob, { fileName: name, extensions: [name.slice(name.lastIndexOf('.'))] });
  return (await unlessClosed(saving.then(() => true))) ?? false;
}

/** Downloads a file at once: a dialog would no longer be allowed some seconds after the click that asked for the file. */
export function downloadFile({ name, blob }: ExportedFile): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // some browsers read it only after this task
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Copies a text to the clipboard and reports the result. @param what a name for it: `the link` */
export async function copyText(notices: Notices, what: string, text: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(text);
    notices.show('info', `Copied ${what}.`, { topic: 'clipboard' });
  } catch {
    notices.show('warning', `The browser does not let this page write to the clipboard: select ${what} and copy it manually.`, {
      topic: 'clipboard',
    });
  }
}
