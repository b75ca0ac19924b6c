import { plural } from '../../../check/words/index.ts';
import type { ImportReport } from '../../../schema/index.ts';
import { visibleLine } from '../../io/index.ts';

export interface ImportedFile {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly status: 'written' | 'overwritten' | 'unchanged';
}

export interface Imported {
  readonly files: readonly ImportedFile[];
  /** What was skipped or ignored, one sentence for each. */
  readonly notes: readonly string[];
}

/** The results of `import` as JSON. */
export const importJson = ({ files, notes }: Imported): string =>
  `${JSON.stringify({ version: 1, files: [...files], notes: [...notes] } satisfies ImportReport)}\n`;

/** The results of `import` for people. */
export function importPretty({ files, notes }: Imported): string {
  const lines = files.map(({ file, status }) => `${status} ${visibleLine(file)}`);
  lines.push(...notes.map((note) => `note: ${visibleLine(note)}`));
  lines.push(
    `${plural(files.length, 'level')} imported; gq solve LEVEL --write adds a run to one, and gq check shows which can be completed`,
  );
  return `${lines.join('\n')}\n`;
}
