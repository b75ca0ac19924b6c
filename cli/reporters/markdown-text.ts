import { visibleLine } from '../io/index.ts';

/** Text on one line that is shown as it is: no markup, no HTML, no mention of a person or an issue, no end of a table's cell. */
export const markdownText = (text: string): string =>
  wellFormedLine(text)
    .replace(/[&<>|\\`*_[\]~]|@|#(?=\d)|:(?=\/\/)|(?<=\bwww)\./g, (found) => {
      if (/[&<>|\\]/.test(found)) return entity(found);
      // a service that looks for mentions and addresses finds none across a comment
      return /[`*_[\]~]/.test(found) ? `\\${found}` : `${found}<!-- -->`;
    })
    // what would begin a list or a heading
    .replace(/^[-+=](?= |$)|^#(?=#{0,5} )|^\d(?=\d*[.)](?: |$))/, entity);

const entity = (character: string): string => `&#${character.charCodeAt(0)};`;

/** Text in the letters of code, in a table's cell as well. */
export function markdownCode(text: string): string {
  const line = wellFormedLine(text);
  if (/^[^`|\\]+$/.test(line) && line.trim() === line) return `\`${line}\``;
  return `<code>${line.replace(/[!-/:-@[-`{-~]/g, entity)}</code>`;
}

/** Lines in the letters of code: a block that nothing in the text can end. */
export function markdownBlock(text: string): string {
  const longest = Math.max(2, ...[...text.matchAll(/`+/g)].map(([run]) => run.length));
  const fence = '`'.repeat(longest + 1);
  return `${fence}text\n${text.trimEnd().split('\n').map(wellFormedLine).join('\n')}\n${fence}\n`;
}

/** Characters that move the cursor or break a line become visible, and so do halves of characters. */
const wellFormedLine = (text: string): string =>
  visibleLine(text)
    .replace(/[\u2028\u2029]/g, ' ')
    .replace(/\p{Surrogate}/gu, '\ufffd');
