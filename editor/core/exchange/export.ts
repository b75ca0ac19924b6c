import { renderSvg } from '../../../picture/index.ts';
import { formatLevel, type LevelFile } from '../../../schema/index.ts';
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

export interface PictureOptions {
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
