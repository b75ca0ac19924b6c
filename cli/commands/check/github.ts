import { plural } from '../../../check/words/index.ts';
import type { CheckedLevel } from '../../check/index.ts';
import { summarize } from '../../check/index.ts';

/** The results of `check` as workflow commands, which GitHub shows at the lines of a pull request, and a summary line. */
export function checkGithub(reports: readonly CheckedLevel[]): string {
  let text = '';
  for (const { file, problems } of reports) {
    for (const { severity, code, message, hint, line, column } of problems) {
      const at = line === null ? '' : `,line=${line},col=${column ?? 1}`;
      text += `::${severity} file=${property(file)}${at},title=${property(code)}::${data(hint === '' ? message : `${message}\n${hint}`)}\n`;
    }
  }
  const counts = Object.entries(summarize(reports)).filter(([, count]) => count > 0);
  return `${text}${plural(reports.length, 'level')}: ${counts.map(([verdict, count]) => `${count} ${verdict}`).join(', ')}\n`;
}

const data = (text: string): string => text.replaceAll('%', '%25').replaceAll('\r', '%0D').replaceAll('\n', '%0A');

const property = (text: string): string => data(text).replaceAll(':', '%3A').replaceAll(',', '%2C');
