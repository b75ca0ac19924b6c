import { plural } from '../../../check/words/index.ts';
import type { ExportReport } from '../../../schema/index.ts';
import type { FileStatus } from '../../io/index.ts';
import { visibleLine } from '../../terminal/index.ts';
import type { Made } from './made.ts';

export interface ExportedFile {
  readonly file: string;
  /** The level files that are in it. */
  readonly levels: readonly string[];
  readonly status: FileStatus;
}

interface Exported {
  readonly files: readonly ExportedFile[];
  readonly warnings: Made['warnings'];
}

/** Files that a warning names before it only counts them. */
const NAMED = 2;

/** Warnings for people: one for all files that it concerns. */
export function warningsInWords(warnings: Made['warnings']): string {
  const files = new Map<string, string[]>();
  for (const { file, message } of warnings) files.set(message, [...(files.get(message) ?? []), visibleLine(file)]);
  return [...files]
    .map(([message, names]) => {
      const more = names.length > NAMED + 1 ? ` and ${names.length - NAMED} more` : '';
      const shown = more === '' ? names : names.slice(0, NAMED);
      return `warning: ${shown.join(', ')}${more}: ${visibleLine(message)}\n`;
    })
    .join('');
}

/** The results of `export` as JSON. */
export function exportJson({ files, warnings }: Exported): string {
  const rows = files.map(({ file, levels, status }) => ({ file, levels: [...levels], status }));
  const report: ExportReport = { version: 1, files: rows, warnings: [...warnings] };
  return `${JSON.stringify(report)}\n`;
}

/** The results of `export` for people. */
export function exportPretty({ files }: Exported): string {
  const lines = files.map(({ file, status, levels }) => `${status} ${visibleLine(file)}: ${plural(levels.length, 'level')}`);
  return `${lines.join('\n')}\n`;
}
