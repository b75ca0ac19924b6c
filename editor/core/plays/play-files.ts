import { directoryOpen, fileOpen } from 'browser-fs-access';
import { decodePlay, playToText } from '../../../game/index.ts';
import { type LevelFile, leavingFolder, type OwnRules } from '../../../schema/index.ts';
import type { Editor } from '../context/index.ts';
import { copyText, keepFile, LONGEST_LINK, linkTo, plainName, unlessClosed } from '../exchange/index.ts';
import { bareTitle, isPlayFile, PLAY_EXTENSION } from '../shelf/index.ts';
import { termsAt } from '../terms/index.ts';

/** Lets the user choose the files of plays. @returns null if none were chosen */
export const choosePlays = (): Promise<readonly File[] | null> =>
  unlessClosed(fileOpen({ description: 'plays', extensions: [PLAY_EXTENSION], multiple: true }));

/** Lets the user choose a folder. @returns the plays in it and in its folders; null if none was chosen */
export async function choosePlayFolder(): Promise<readonly File[] | null> {
  const all = await unlessClosed(directoryOpen({ recursive: true }));
  return all?.filter((file): file is Extract<typeof file, File> => file instanceof File && isPlayFile(file)) ?? null;
}

/** All files of a folder that was dropped, and of its folders. */
async function filesIn(entry: FileSystemEntry): Promise<File[]> {
  if (entry.isFile) {
    return new Promise((resolve) =>
      (entry as FileSystemFileEntry).file(
        (file) => resolve([file]),
        () => resolve([]),
      ),
    );
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const files: File[] = [];
  for (;;) {
    // a browser lists at most 100 entries at a time
    const entries = await new Promise<FileSystemEntry[]>((resolve) => reader.readEntries(resolve, () => resolve([])));
    if (entries.length === 0) return files;
    for (const one of entries) files.push(...(await filesIn(one)));
  }
}

/** What was dropped: files, and the plays in folders. Folders may contain anything; what else is in them is left out. */
export async function droppedFiles(data: DataTransfer): Promise<readonly File[]> {
  // must be asked for before the first wait, as the data is gone afterwards
  const entries = [...data.items].flatMap((item) => (item.kind === 'file' ? (item.webkitGetAsEntry?.() ?? []) : []));
  const files = [...data.files];
  const folders = entries.filter(({ isDirectory }) => isDirectory);
  if (folders.length === 0) return files;
  const names = new Set(folders.map(({ name }) => name));
  const inFolders = await Promise.all(folders.map(filesIn));
  return [...files.filter(({ name }) => !names.has(name)), ...inFolders.flat().filter(isPlayFile)];
}

/** A play to be sent. */
export interface SharedPlay {
  /** What to call it: `attempt 3`. */
  readonly title: string;
  readonly bytes: Uint8Array;
  /** The level as it was played, and the rules of its folder; null if it is not known. */
  readonly played: { readonly file: LevelFile; readonly rules: OwnRules } | null;
}

/** The name of the file that a play is saved as. @param level the name of the level */
export const playFileName = (level: string, title: string): string =>
  `${[level, bareTitle(title)].map((part) => plainName(part) || 'play').join('-')}${PLAY_EXTENSION}`;

/** Saves a play as a `.gqr` file. */
export async function savePlay(editor: Editor, level: string, { title, bytes }: SharedPlay): Promise<void> {
  const name = playFileName(level, title);
  const blob = new Blob([new Uint8Array(bytes)], { type: 'application/octet-stream' });
  if (await keepFile({ name, blob })) editor.notices.show('info', `${name} was saved.`, { topic: 'plays' });
}

/** Copies a play as text, which can be pasted where a file can't be. */
export const copyPlay = ({ notices }: Editor, { title, bytes }: SharedPlay): Promise<void> =>
  copyText(notices, `${title} as text`, playToText(bytes));

/** Copies a link to this page with a play and its level. */
export async function copyPlayLink({ notices, terms }: Editor, { title, bytes, played }: SharedPlay): Promise<void> {
  if (played === null) {
    notices.show('warning', 'The level has changed since this play, so a link can’t include it. Save the play as a file.', {
      topic: 'clipboard',
    });
    return;
  }
  // runs would give the solution away, and the play does not need them
  const { runs: _, ...bare } = leavingFolder(played.file, played.rules);
  // the page of the link plays what the play was, whatever this one shows now
  const decoded = decodePlay(bytes);
  const { shown } = terms.getState();
  const under = decoded.ok ? termsAt(shown, decoded.play.accuracy) : shown;
  const linking = await linkTo(bare, under, `${location.origin}${location.pathname}`);
  const url = linking.ok ? `${linking.url}&play=${playToText(bytes)}` : '';
  if (!linking.ok || url.length > LONGEST_LINK) {
    notices.show('warning', 'The level is too large for a link. Save the play as a file, and send both files.', {
      topic: 'clipboard',
    });
    return;
  }
  await copyText(notices, `a link to ${title}`, url);
}
