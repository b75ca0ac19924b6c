import { importOriginal, type Level, resolveLevel } from '../../schema/index.ts';
import { originalLevels } from './recordings.ts';

/** The original's levels by their number (the place in its array), as the toolkit imports them, with recoil as the original has it. */
export function importedLevels(): Map<number, Level> {
  const imported = importOriginal(originalLevels(), { recoil: true });
  if (!imported.ok) throw new Error(imported.problems.map((problem) => problem.message).join('\n'));
  return new Map(imported.levels.map(({ slug, file }) => [Number(slug.replace(/^level-/, '')), resolveLevel(file)]));
}
