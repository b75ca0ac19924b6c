import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { renderSvg } from '../../picture/index.ts';
import { type LevelFile, type OwnRules, resolveLevel } from '../../schema/index.ts';

interface PictureOptions {
  /** The rules of the folder. */
  readonly rules: OwnRules;
  readonly accuracy: AccuracyName;
  readonly theme: 'dark' | 'light';
  /** px */
  readonly width: number;
}

/** A data URL of an SVG picture of a level with its first run. */
export function levelPicture(file: LevelFile, { rules, accuracy, theme, width }: PictureOptions): string {
  const level = resolveLevel(file, rules);
  const run = level.runs.length === 0 ? undefined : simulate(compile(level, accuracy), level.runs[0].holds);
  return `data:image/svg+xml,${encodeURIComponent(renderSvg(level, { run, width, theme, words: false }))}`;
}
