import { plural } from '../../../check/words/index.ts';
import { visibleLine } from '../../visible.ts';

export interface ImportedFile {
  readonly file: string;
  /** The level's name. */
  readonly level: string;
  readonly status: 'written' | 'overwritten' | 'unchanged';
}

export interface Imported {
  readonly files: readonly ImportedFile[];
  /** What was skipped or ignored, a sentence each. */
  readonly notes: readonly string[];
}

/** What `import` did, for a program. */
export const importJson = (imported: Imported): string => `${JSON.stringify(imported)}\n`;

/** What `import` did, for a person. */
export function importPretty({ files, notes }: Imported): string {
  const lines = files.map(({ file, status }) => `${status} ${visibleLine(file)}`);
  lines.push(...notes.map((note) => `note: ${visibleLine(note)}`));
  lines.push(
    `${plural(files.length, 'level')} imported; gq solve LEVEL --write adds a run to one, and gq check shows which can be completed`,
  );
  return `${lines.join('\n')}\n`;
}
