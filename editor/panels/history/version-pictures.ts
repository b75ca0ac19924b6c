import type { Terms } from '../../../engine/index.ts';
import type { Editor, OpenLevel } from '../../context/index.ts';
import { pictureKey, picturesOf } from '../../pictures/index.ts';
import type { Version } from '../../versions/index.ts';

/** How a version is drawn and judged. */
export interface DrawnBy {
  readonly theme: 'dark' | 'light';
  readonly terms: Terms;
}

/** px: twice the shown size, for high-density screens */
const WIDTH = 128;

/** Versions with the same text look alike. */
export const versionKey = ({ check }: Version, by: DrawnBy): string => pictureKey(`version ${check}`, { ...by, width: WIDTH });

/** Asks for the picture of a version of an open level unless there is one. */
export function wantPicture(editor: Editor, level: OpenLevel, version: Version, by: DrawnBy): void {
  const text = () => level.opened.versions.text(version);
  picturesOf(editor).want(versionKey(version, by), { ...by, width: WIDTH, text });
}
