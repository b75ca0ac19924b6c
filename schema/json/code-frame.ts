const AROUND = 2;
const WIDTH = 110;

/**
 * Replaces characters that have no width, take the place of others, or would control a terminal, each by one visible character,
 * so that the caret stays in the right column.
 */
function visible(text: string): string {
  return text.replaceAll('\t', ' ').replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, '·');
}

/**
 * Quotes the lines around a place in a text, numbered, with a caret below the place. Long lines are cut to the part around the
 * column.
 *
 * @param text - the whole text
 * @param line - line of the place, from 1
 * @param column - column of the place, from 1, in UTF-16 code units
 * @returns up to five lines of the text and the line with the caret, separated by LF
 */
export function codeFrame(text: string, line: number, column: number): string {
  const lines = text.split(/\r?\n/);
  const first = Math.max(1, line - AROUND);
  const last = Math.min(lines.length, line + AROUND);
  const digits = String(last).length;
  const cut = column > WIDTH - 20 ? column - (WIDTH >> 1) : 0;
  const rows: string[] = [];
  for (let n = first; n <= last; n++) {
    const whole = lines[n - 1];
    const shown = visible(whole.slice(cut, cut + WIDTH));
    const before = cut > 0 && whole.length > 0 ? '…' : '';
    const after = whole.length > cut + WIDTH ? '…' : '';
    rows.push(`${n === line ? '>' : ' '} ${String(n).padStart(digits)} | ${before}${shown}${after}`.trimEnd());
    if (n !== line) continue;
    // surrogate pairs are two code units and one character
    const gap = Array.from(visible(whole.slice(cut, column - 1))).length + (before === '' ? 0 : 1);
    rows.push(`  ${' '.repeat(digits)} | ${' '.repeat(gap)}^`);
  }
  return rows.join('\n');
}
