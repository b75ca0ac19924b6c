/** The name of merge driver, diff driver and diff tool in git's configuration. */
export const DRIVER = 'gq-level';

const COMMENT = '# gq git-setup: levels are merged and compared by gq';
const LINE = `*.level.json merge=${DRIVER} diff=${DRIVER} text eol=lf`;

const plain = (line: string): string => line.replace(/\r$/, '');
const isOurs = (line: string): boolean => plain(line) === COMMENT || plain(line) === LINE;

const OURS = LINE.split(' ');

/** A line for levels that names gq, and to which somebody has added attributes of their own. */
function isEdited(line: string): boolean {
  const words = plain(line).trim().split(/\s+/);
  return words[0] === OURS[0] && words.length > OURS.length && OURS.every((word) => words.includes(word));
}

/** Whether a `.gitattributes` has the line for levels, perhaps with further attributes. */
export const hasAttributes = (text: string): boolean => text.split('\n').some((line) => plain(line) === LINE || isEdited(line));

/** The numbers, from 1, of lines for levels that somebody has edited: `withoutAttributes` leaves them. */
export const editedLines = (text: string): number[] => text.split('\n').flatMap((line, i) => (isEdited(line) ? [i + 1] : []));

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
