import { formatLevel, type LevelFile } from '../../../schema/index.ts';
import { keptWith } from '../kept/index.ts';

/** The canonical text of a level file. It is made once: saving, telling other tabs and recording need the same one. */
export const levelText = keptWith((file: LevelFile) => formatLevel(file));
