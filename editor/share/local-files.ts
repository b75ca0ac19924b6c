import { fileOpen, fileSave } from 'browser-fs-access';
import type { ExportedFile } from './export.ts';

/** Whether an error says that the person closed the dialog. */
const isCancel = (error: unknown): boolean => error instanceof DOMException && error.name === 'AbortError';

/** Lets the person choose files with levels. @returns null when they chose none */
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

/** Gives a file to the person, by a dialog or as a download. @returns whether it was kept */
export async function keepFile({ name, blob }: ExportedFile): Promise<boolean> {
  try {
    await fileSave(blob, { fileName: name, extensions: [name.slice(name.lastIndexOf('.'))] });
    return true;
  } catch (error) {
    if (isCancel(error)) return false;
    throw error;
  }
}
