import type { InitReport } from '../../../schema/index.ts';
import { visibleLine } from '../../io/index.ts';

/** The results of `init` as JSON. */
export const initJson = (report: InitReport): string => `${JSON.stringify(report)}\n`;

const WOULD = { written: 'would write', changed: 'would change', unchanged: 'unchanged', left: 'left' };

/** The results of `init` for people. */
export function initPretty({ dryRun, files, next }: InitReport): string {
  const lines = files.map(({ file, status, note }) => {
    const words = dryRun ? WOULD[status] : status;
    return `${words} ${visibleLine(file)}${note === null ? '' : `: ${note}`}`;
  });
  const steps = next.map((step) => `  ${visibleLine(step)}`);
  return `${lines.join('\n')}\n\n${dryRun ? 'nothing was written; afterwards' : 'next'}:\n${steps.join('\n')}\n`;
}
