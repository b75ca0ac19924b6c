/** Rows of cells as lines: every column as wide as its widest cell, numbers to the right, no space at the ends. */
export function alignColumns(rows: readonly (readonly string[])[]): string[] {
  const widths: number[] = [];
  for (const row of rows) for (const [i, cell] of row.entries()) widths[i] = Math.max(widths[i] ?? 0, [...cell].length);
  return rows.map((row) =>
    row
      .map((cell, i) => pad(cell, widths[i]))
      .join('  ')
      .trimEnd(),
  );
}

function pad(cell: string, width: number): string {
  const space = ' '.repeat(width - [...cell].length);
  return /^-?\d/.test(cell) ? space + cell : cell + space;
}
