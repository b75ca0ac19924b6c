import { jumpsOf } from '../../check/pack/index.ts';
import { levelsOfPack } from '../../schema/index.ts';
import { type FoundPack, levelIdOf, visibleLine } from '../io/index.ts';
import { readPackFile } from '../pack-file/index.ts';
import type { MeasuredLevel } from './measured-level.ts';

/** The curve of difficulty of a pack. */
export interface PackCurve {
  readonly file: string;
  readonly name: string;
  /** The files of the listed levels, in the order in which they are played. */
  readonly levels: readonly string[];
  /** The grade of each; null where none was measured. */
  readonly grades: readonly (number | null)[];
  /** Levels that are much harder than all before them. */
  readonly jumps: readonly { readonly file: string; readonly after: string; readonly by: number }[];
}

/** The curve of each pack that is valid. @param levels in the order of the packs */
export function curvesOf(packs: readonly FoundPack[], levels: readonly MeasuredLevel[]): PackCurve[] {
  return packs.flatMap(({ file, folder, levels: files }) => {
    const read = readPackFile(file);
    if ('unreadable' in read || !read.reading.ok) return [];
    const { pack } = read.reading;
    const listed = new Set(levelsOfPack(pack));
    const below = new Set(files);
    const inIt = levels.filter((level) => below.has(level.file) && listed.has(levelIdOf(folder, level.file)));
    const grades = inIt.map(({ difficulty }) => difficulty?.grade.value ?? null);
    const jumps = jumpsOf(grades).map(({ index, from, by }) => ({ file: inIt[index].file, after: inIt[from].file, by }));
    return [{ file, name: pack.name, levels: inIt.map((level) => level.file), grades, jumps }];
  });
}

/** The curves for people: the grades in order, and what jumps. */
export function curvesInWords(curves: readonly PackCurve[]): string {
  return curves
    .map(({ file, grades, jumps }) => {
      const list = grades.map((grade) => grade?.toFixed(1) ?? '-').join(' ');
      const lines = jumps.map(
        (jump) =>
          `  a jump: ${visibleLine(jump.file)} is ${jump.by.toFixed(1)} above the hardest level before it, ${visibleLine(jump.after)}\n`,
      );
      return `in the order of ${visibleLine(file)}: ${list}\n${lines.join('')}`;
    })
    .join('');
}
