import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { expect } from 'vitest';

export const PROJECT = fileURLToPath(new URL('../..', import.meta.url));

/** Whether pages are to be written anew, as snapshots are: `vitest --update`. */
export const isUpdating = (): boolean => expect.getState().snapshotState.snapshotUpdateState === 'all';

/** A fenced block of code in a page. */
export interface Block {
  readonly language: string;
  /** From the info string: `title=my/moon.level.json` names the file that the reader makes. */
  readonly title: string | undefined;
  readonly code: string;
  /** Line of the page on which the code begins, from 1. */
  readonly line: number;
}

export interface Page {
  /** Relative to the project, with `/`. */
  readonly path: string;
  readonly text: string;
  readonly blocks: readonly Block[];
  /** The text with fenced blocks blanked, line for line. */
  readonly prose: string;
}

/** Pages whose commands are run. */
export const RUN_PAGES: readonly string[] = [
  'README.md',
  ...readdirSync(join(PROJECT, 'docs'))
    .filter((name) => name.endsWith('.md'))
    .sort()
    .map((name) => `docs/${name}`),
];

/** Pages whose links and names are checked. */
export const ALL_PAGES: readonly string[] = [
  ...RUN_PAGES,
  'ARCHITECTURE.md',
  'CONTRIBUTING.md',
  'SECURITY.md',
  'CHANGELOG.md',
  'bench/README.md',
];

export function readPage(path: string): Page {
  const text = readFileSync(join(PROJECT, path), 'utf8');
  const lines = text.split('\n');
  const blocks: Block[] = [];
  const prose: string[] = [];
  for (let i = 0; i < lines.length; i++) {
    const fence = /^(\s*)(`{3,})(\S*)\s*(.*)$/.exec(lines[i]);
    if (fence === null) {
      prose.push(lines[i]);
      continue;
    }
    const [, indent, marks, language, info] = fence;
    const start = i + 1;
    while (++i < lines.length && lines[i].trim() !== marks);
    if (i === lines.length) throw new Error(`${path}:${start}: the block of code does not end`);
    const code = lines.slice(start, i).map((line) => (line.startsWith(indent) ? line.slice(indent.length) : line));
    blocks.push({ language, title: /title=(\S+)/.exec(info)?.[1], code: code.join('\n'), line: start + 1 });
    for (let line = start - 1; line <= i; line++) prose.push('');
  }
  return { path, text, blocks, prose: prose.join('\n') };
}

/** What follows `$ ` in a console block, and what is printed. */
export interface Shown {
  readonly command: string;
  readonly printed: string;
  /** Line of the page of the command, from 1. */
  readonly line: number;
}

export function shownIn(block: Block): Shown[] {
  const shown: Shown[] = [];
  const lines = block.code.split('\n');
  for (let i = 0; i < lines.length; ) {
    const first = i++;
    while (i < lines.length && !lines[i].startsWith('$ ')) i++;
    const printed = lines
      .slice(first + 1, i)
      .join('\n')
      .trimEnd();
    shown.push({ command: lines[first].replace(/^\$ /, ''), printed, line: block.line + first });
  }
  return shown;
}
