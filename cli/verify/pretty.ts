import { plural } from '../../check/words/index.ts';
import type { VerifyReport } from '../../schema/index.ts';
import { type Colors, visibleLine } from '../terminal/index.ts';

/** One play for people: its verdict, where it comes from, and why. */
export function playPretty(report: VerifyReport, colors: Colors): string {
  const { verdict, message, level, accuracy, time, signs, challenge } = report;
  const isOk = verdict === 'ok';
  const { file, line, id } = report;
  const where = file === null ? `line ${line}` : line === null ? file : `${file}#${line}`;
  const place = id === null ? where : `${where} (${id})`;
  const of = level?.name === null || level === null ? '' : `${level.name}, `;
  const end = time === null ? '' : `, after ${time.toFixed(3)} s`;
  const what = isOk ? `${of}${accuracy}: ${message}${end}` : `${of}${message}`;
  const about = [
    ...(signs?.publishedRun == null ? [] : [`repeats the level's own run ${JSON.stringify(signs.publishedRun)}`]),
    ...(signs == null || signs.fastEdges === 0
      ? []
      : [`${plural(signs.fastEdges, 'press or release', 'presses and releases')} faster than 2 ticks`]),
    ...(challenge === 'unchecked' ? ['its challenge is not checked: --challenge-key checks it'] : []),
  ];
  const head = `${(isOk ? colors.green : colors.red)(verdict.padEnd(14))} ${visibleLine(place)}`;
  return [head, `  ${visibleLine(what)}`, ...about.map((line) => `  ${visibleLine(line)}`)].map((line) => `${line}\n`).join('');
}

/** How many plays there are of each verdict. */
export function countsPretty(counts: ReadonlyMap<string, number>): string {
  const total = [...counts.values()].reduce((sum, count) => sum + count, 0);
  return `${plural(total, 'play')}: ${[...counts].map(([verdict, count]) => `${count} ${verdict}`).join(', ')}\n`;
}
