import { fileOpen, fileSave } from 'browser-fs-access';
import { renderSvg } from '../../../picture/index.ts';
import { formatLevel, type LevelFile } from '../../../schema/index.ts';
import type { Notices } from '../notices/index.ts';
import type { LiveProof } from '../proof/index.ts';

/** A file to save. */
export interface ExportedFile {
  readonly name: string;
  readonly blob: Blob;
}

/** The level as a file for `gq`. @param id of the level */
export function levelFile(id: string, file: LevelFile): ExportedFile {
  const name = `${id.split('/').at(-1)}.level.json`;
  return { name, blob: new Blob([formatLevel(file)], { type: 'application/json' }) };
}

interface PictureOptions {
  readonly theme: 'dark' | 'light';
  /** px */
  readonly width: number;
  readonly withRun: boolean;
}

/** A picture of the level, with the shown run if wanted. */
export function pictureSvg({ level, run, full }: LiveProof, { theme, width, withRun }: PictureOptions): string {
  return withRun && full !== null
    ? renderSvg(level, { run: full, holds: run.holds, width, theme })
    : renderSvg(level, { width, theme });
}

/**
 * The same picture as a PNG.
 * @param scale pixels per px
 * @throws (rejects) if the browser can't draw it
 */
export async function toPng(svg: string, scale = 2): Promise<Blob> {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  try {
    await image.decode();
    const canvas = document.createElement('canvas');
    canvas.width = Math.round(image.naturalWidth * scale);
    canvas.height = Math.round(image.naturalHeight * scale);
    const context = canvas.getContext('2d');
    if (context === null) throw new Error('the browser gives no canvas to draw on');
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) => {
      canvas.toBlob(
        (blob) => (blob === null ? reject(new Error('the picture is too large for this browser')) : resolve(blob)),
        'image/png',
      );
    });
  } finally {
    URL.revokeObjectURL(image.src);
  }
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
