import { compile, simulate, type Terms } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import { type LevelFile, resolveLevel } from '../../../schema/index.ts';

interface PictureOptions {
  readonly terms: Terms;
  readonly theme: 'dark' | 'light';
  /** px */
  readonly width: number;
}

/** A data URL of an SVG picture of a level with its first run. */
export function levelPicture(file: LevelFile, { terms, theme, width }: PictureOptions): string {
  const level = resolveLevel(file, terms.rules);
  const run = level.runs.length === 0 ? undefined : simulate(compile(level, terms), level.runs[0].holds);
  return `data:image/svg+xml,${encodeURIComponent(renderSvg(level, { run, width, theme, words: false }))}`;
}
