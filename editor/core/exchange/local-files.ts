import { fileOpen, fileSave } from 'browser-fs-access';
import type { ExportedFile } from './export.ts';

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
