/**
 * Formats rows of cells as lines. Every column is as wide as its widest cell; lines have no trailing spaces.
 * @param right the columns, from 0, that are aligned to the right
 */
export function alignColumns(rows: readonly (readonly string[])[], right: readonly number[] = []): string[] {
  const widths: number[] = [];
  for (const row of rows) for (const [i, cell] of row.entries()) widths[i] = Math.max(widths[i] ?? 0, length(cell));
  const pad = (cell: string, i: number): string => {
    const space = ' '.repeat(widths[i] - length(cell));
    return right.includes(i) ? space + cell : cell + space;
  };
  return rows.map((row) => row.map(pad).join('  ').trimEnd());
}

/** The number of characters, not of UTF-16 code units. */
const length = (cell: string): number => [...cell].length;
