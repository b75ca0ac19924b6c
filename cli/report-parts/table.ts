/** How a table is laid out. */
export interface TableLayout {
  /** The columns, from 0, that are aligned to the right. */
  readonly right?: readonly number[];
  /** The titles of the columns; a line of their own where the table fits. */
  readonly head?: readonly string[];
  /** The column that begins a row where the table does not fit; by default the first. */
  readonly lead?: number;
  /** The characters of a line of the terminal; null, or nothing: a line can be as long as it likes. */
  readonly width?: number | null;
}

/** what the further lines of a row begin with */
const INDENT = '    ';

/**
 * Formats rows of cells as lines. Every column is as wide as its widest cell; lines have no trailing spaces. Where that does not
 * fit into the width, every row is a text of several lines instead, in which each cell has the title of its column.
 * @returns a text for each row, after one for the titles if there are any (empty where they stand in the rows)
 */
export function alignColumns(rows: readonly (readonly string[])[], layout: TableLayout = {}): string[] {
  const { right = [], head, width = null } = layout;
  const all = head === undefined ? rows : [head, ...rows];
  const widths: number[] = [];
  for (const row of all) for (const [i, cell] of row.entries()) widths[i] = Math.max(widths[i] ?? 0, length(cell));
  const pad = (cell: string, i: number): string => {
    const space = ' '.repeat(widths[i] - length(cell));
    return right.includes(i) ? space + cell : cell + space;
  };
  const lines = all.map((row) => row.map(pad).join('  ').trimEnd());
  if (width === null || lines.every((line) => length(line) <= width)) return lines;
  const narrow = rows.map((row) => stacked(row, layout, width));
  return head === undefined ? narrow : ['', ...narrow];
}

/** A row as lines of at most `width` characters, if no word is longer. */
function stacked(row: readonly string[], { head = [], lead = 0 }: TableLayout, width: number): string {
  const titled = row.map((cell, i) => (cell === '' || i === lead || !head[i] ? cell : `${head[i]} ${cell}`));
  const cells = [titled[lead] ?? '', ...titled.filter((_, i) => i !== lead)].filter((cell) => cell !== '');
  const lines: string[] = [];
  let line = '';
  const put = (text: string, gap: string): void => {
    if (line === '' || length(line + gap + text) <= width) line += (line === '' ? '' : gap) + text;
    else {
      lines.push(line);
      line = INDENT + text;
    }
  };
  for (const cell of cells) {
    // a cell stays whole if it fits into a line
    if (length(INDENT + cell) <= width) put(cell, '  ');
    else for (const [i, word] of cell.split(' ').entries()) put(word, i === 0 ? '  ' : ' ');
  }
  return [...lines, line].join('\n');
}

/** The number of characters, not of UTF-16 code units. */
const length = (cell: string): number => [...cell].length;
