/** The name of merge driver, diff driver and diff tool in git's configuration. */
export const DRIVER = 'gq-level';

const COMMENT = '# gq git-setup: levels are merged and compared by gq';
const LINE = `*.level.json merge=${DRIVER} diff=${DRIVER} text eol=lf`;

const plain = (line: string): string => line.replace(/\r$/, '');
const isOurs = (line: string): boolean => plain(line) === COMMENT || plain(line) === LINE;

/** Whether a `.gitattributes` has the line for levels. */
export const hasAttributes = (text: string): boolean => text.split('\n').some((line) => plain(line) === LINE);

/** Adds the line for levels to a `.gitattributes`, at its end, where it wins over other lines. The rest stays as it is. */
export function withAttributes(text: string): string {
  if (hasAttributes(text)) return text;
  const lines = text.split('\n');
  const end = lines.length > 1 && plain(lines[0]) !== lines[0] ? '\r' : '';
  const added = [COMMENT, LINE].map((line) => line + end);
  // a last line without a line end stays one, so that undo restores the file
  if (lines.at(-1) === '') lines.splice(-1, 0, ...added);
  else lines.push(COMMENT + end, LINE);
  return lines.join('\n');
}

/** Removes what `withAttributes` has added. */
export function withoutAttributes(text: string): string {
  return text
    .split('\n')
    .filter((line) => !isOurs(line))
    .join('\n');
}
