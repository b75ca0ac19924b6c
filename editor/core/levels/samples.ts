import { type LevelFile, readLevel } from '../../../schema/index.ts';

/** A level that comes with the toolkit. */
export interface Sample {
  /** The name of its file, without the extension. */
  readonly stem: string;
  readonly file: LevelFile;
}

const TEXTS = import.meta.glob<string>('../../../levels/*.level.json', { query: '?raw', import: 'default', eager: true });

/** The shipped levels, in the order of play. */
export const SAMPLES: readonly Sample[] = Object.entries(TEXTS)
  .sort(([a], [b]) => (a < b ? -1 : 1))
  .flatMap(([path, text]) => {
    const reading = readLevel(text);
    const stem = path.slice(path.lastIndexOf('/') + 1, -'.level.json'.length);
    return reading.ok ? [{ stem, file: reading.document.file }] : [];
  });
