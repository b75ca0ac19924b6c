import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { renderSvg } from '../../picture/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';

/** Address of a picture of a level with its first run, as an SVG in itself. @param width px */
export function levelPicture(file: LevelFile, accuracy: AccuracyName, theme: 'dark' | 'light', width: number): string {
  const level = resolveLevel(file);
  const run = level.runs.length === 0 ? undefined : simulate(compile(level, accuracy), level.runs[0].holds);
  return `data:image/svg+xml,${encodeURIComponent(renderSvg(level, { run, width, theme, words: false }))}`;
}
