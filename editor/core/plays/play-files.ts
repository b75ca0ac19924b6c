import { directoryOpen, fileOpen } from 'browser-fs-access';
import { createStore, type StoreApi } from 'zustand/vanilla';
import type { Editor } from '../context/index.ts';
import { unlessClosed } from '../exchange/index.ts';
import { keptWith } from '../kept/index.ts';
import { isPlayFile, PLAY_EXTENSION } from '../shelf/index.ts';

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

/** What is read and verified at the moment. */
export interface Reading {
  readonly what: 'files' | 'plays';
  readonly done: number;
  readonly of: number;
  readonly cancel: () => void;
}

/** Opening happens in turns, as each adds to what is known of the plays before. */
interface Desk {
  readonly reading: StoreApi<Reading | null>;
  last: Promise<unknown>;
}

export const deskOf = keptWith<Editor, Desk>(() => ({
  reading: createStore<Reading | null>(() => null),
  last: Promise.resolve(),
}));

/** What is read and verified at the moment; null: nothing. */
export const readingOf = (editor: Editor): StoreApi<Reading | null> => deskOf(editor).reading;

/** Does something once what was begun before is done. */
export function inTurn(editor: Editor, act: () => Promise<void>): Promise<void> {
  const desk = deskOf(editor);
  const next = desk.last.then(act).finally(() => desk.reading.setState(null, true));
  desk.last = next.catch(() => {});
  return next;
}
