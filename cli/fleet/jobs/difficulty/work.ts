import { type MeasuredLevel, type MeasureSettings, measureAgain, measureContent, unreadable } from '../../../difficulty/index.ts';
import { type Json, oneByOne, type Work } from '../../job.ts';

/** Measures how hard levels are. */
export const openDifficulty = (settings: MeasureSettings): Work => ({
  work: oneByOne(({ name, content }) =>
    recordOf(content instanceof Uint8Array ? measureContent(name, content, settings) : unreadable(name, content, settings.terms)),
  ),
  replay({ name, content }, result) {
    if (!(content instanceof Uint8Array)) return 'a file that can no longer be read';
    // a search is not repeated: the run that it has found is measured again
    const again = measureAgain(levelOf(name, result), content, settings);
    if (again.difficulty === null) return `not measured: ${again.why}`;
    return JSON.stringify(recordOf(again)) === JSON.stringify(result) ? null : 'measured, but not as recorded';
  },
});

/** What is recorded of a measured level: all but its file, which a record has beside it. */
const recordOf = ({ file: _, ...rest }: MeasuredLevel): Json => rest as unknown as Json;

export const levelOf = (file: string, result: Json): MeasuredLevel => ({ file, ...result }) as unknown as MeasuredLevel;
