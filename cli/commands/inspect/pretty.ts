import { plural } from '../../../check/words/index.ts';
import { COUNTED, type Inspection } from '../../inspection.ts';
import { type Colors, visibleLine } from '../../io/index.ts';
import { alignColumns, showFileProblems } from '../../report-parts/index.ts';

/** The results of `inspect` for people. */
export function inspectPretty(
  { file, level, effects, counts, modes, work, problems }: Inspection,
  colors: Colors,
  width: number | null = null,
): string {
  const list = (rows: readonly { readonly name: string; readonly because: string }[]): string =>
    alignColumns(
      rows.map(({ name, because }) => [name, because]),
      { width: width === null ? null : width - 2 },
    )
      .map((line) => `${line.replace(/^/gm, '  ')}\n`)
      .join('');
  const has = COUNTED.filter(({ key }) => counts[key] > 0).map(({ key, one, many }) => plural(counts[key], one, many));
  let text = `${colors.bold(visibleLine(level))}: ${has.length === 0 ? 'only the black hole' : has.join(', ')}\n`;
  text += `\n${colors.bold('simulated')}\n${list(effects.simulated)}`;
  if (effects.notCalledFor.length > 0) text += `\n${colors.bold('not called for')}\n${list(effects.notCalledFor)}`;
  if (work.pieces > 0) {
    const { pieces, forceEvaluations, guards, roots } = work;
    text += `\nthe first run takes ${pieces} pieces of motion, ${forceEvaluations} force evaluations, ${guards} guards, ${roots} roots\n`;
    const spent = modes.map(({ name, share }) => `${(100 * share).toFixed(1)} % ${name}`);
    text += `time by kind of motion: ${spent.join(', ')}\n`;
  }
  if (problems.length > 0) text += `\n${showFileProblems(file, problems, colors)}`;
  return text;
}
