import { fileOpen, fileSave } from 'browser-fs-access';
import type { ExportedFile } from './export.ts';

/** Whether an error means that the user closed the dialog. */
const isCancel = (error: unknown): boolean => error instanceof DOMException && error.name === 'AbortError';

/** Lets the user choose level files. @returns null if none were chosen */
export async function chooseFiles(): Promise<readonly File[] | null> {
  try {
    return await fileOpen({
      description: 'levels',
      mimeTypes: ['application/json'],
      extensions: ['.json'],
      multiple: true,
    });
  } catch (error) {
    if (isCancel(error)) return null;
    throw error;
  }
}

/** Saves a file for the user, by a dialog or as a download. @returns whether it was saved */
export async function keepFile({ name, blob }: ExportedFile): Promise<boolean> {
  try {
    await fileSave(blob, { fileName: name, extensions: [name.slice(name.lastIndexOf('.'))] });
    return true;
  } catch (error) {
    if (isCancel(error)) return false;
    throw error;
  }
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
