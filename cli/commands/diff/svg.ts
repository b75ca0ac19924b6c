import { outcomeInWords } from '../../../check/words/index.ts';
import { renderComparison } from '../../../picture/comparison/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import type { DiffedLevel, PlayedVersion, PlayedVersions } from '../../diff/index.ts';
import { linesOf } from './text.ts';

/** How a picture is drawn. */
export interface PictureOptions {
  readonly width: number;
  readonly theme: 'dark' | 'light';
}

/** The run of a version with the label of its timeline. */
export const labelled = (when: string, { level, run, judged }: PlayedVersion) =>
  run === null || judged === null ? [] : [{ run, label: `${when}: ${judged.name}, ${outcomeInWords(run, level.range)}` }];

/** Both versions of a level in one picture; a level that is there on one side only is drawn alone. null: there is none. */
export function diffSvg(diffed: DiffedLevel, { before, after, marks }: PlayedVersions, options: PictureOptions): string | null {
  const only = before ?? after;
  if (only === null) return null;
  const name = (after ?? only).level.name;
  if (before === null || after === null) {
    const note = diffed.before === null ? 'added' : diffed.after === null ? 'removed' : linesOf(diffed).join('; ');
    return renderSvg(only.level, { ...(only.run !== null && { run: only.run }), ...options, note });
  }
  const note = [...linesOf(diffed), ...diffed.effects].join('; ');
  const runs = [...labelled('before', before), ...labelled('after', after)];
  return renderComparison(before.level, after.level, marks, { ...options, runs, title: name, note }).svg;
}
