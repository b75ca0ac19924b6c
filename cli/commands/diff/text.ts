import { plural } from '../../../check/words/index.ts';
import { isSame } from '../../../schema/index.ts';
import type { Diff, DiffedLevel, DiffStatus, JudgedVersion } from '../../diff/index.ts';
import { type Colors, visibleLine } from '../../terminal/index.ts';

/** What each status is called in a summary, in its order there. */
export const STATUS_WORDS: Readonly<Record<DiffStatus, string>> = {
  changed: 'changed',
  added: 'added',
  removed: 'removed',
  renamed: 'renamed',
  layout: 'only laid out anew',
  rules: 'changed by the rules of the folder',
};

/** The changed rules of the configuration, in words. */
export const rulesInWords = ({ rules }: Pick<Diff, 'rules'>): string[] =>
  rules.map(({ rule, before, after }) => `${rule} ${before ?? 'unset'} -> ${after ?? 'unset'}`);

/** What else of the terms differs between the two sides, in words. */
export function termsChangesInWords({ terms: { before, after } }: Pick<Diff, 'terms'>): string[] {
  const changes = [
    ['accuracy', before.accuracy.name, after.accuracy.name],
    ['maxTime', before.maxTime, after.maxTime],
    ['maxWork', before.maxWork, after.maxWork],
  ] as const;
  return changes.flatMap(([name, old, now]) => (old === now ? [] : [`${name} ${old} -> ${now}`]));
}

/** A path, and the one that it had before. */
export function pathInWords({ before, after }: Pick<DiffedLevel, 'before' | 'after'>): string {
  const [old, now] = [before?.file, after?.file];
  return old === undefined || now === undefined || old === now ? (now ?? old ?? '') : `${old} -> ${now}`;
}

/** The changes of a level, in words; also where it is not a valid level, or only its layout changed. */
export function linesOf({ status, words, before, after }: DiffedLevel): string[] {
  const invalid = [
    ['before', before],
    ['after', after],
  ] as const;
  const problems = invalid.flatMap(([when, version]) =>
    version?.verdict === 'invalid' ? [`${when}: ${problemOf(version)}`] : [],
  );
  if (status === 'layout') return ['only the layout changed'];
  if (status === 'rules') {
    const isOfRules = !isSame(before?.terms.rules, after?.terms.rules);
    return [`the file is the same; the ${isOfRules ? 'rules' : 'terms'} of its folder changed`];
  }
  return [...words, ...problems];
}

function problemOf({ file, problems }: JudgedVersion): string {
  const [{ message, line, column }] = problems;
  const place = line === null ? '' : `${file}:${line}:${column ?? 1}: `;
  const more = problems.length > 1 ? ` (and ${plural(problems.length - 1, 'more problem')})` : '';
  return `${place}${message}${more}`;
}

/** How many levels have each status: `2 changed, 1 added`. */
export function countsInWords(levels: readonly DiffedLevel[]): string {
  const counts = (Object.keys(STATUS_WORDS) as DiffStatus[]).map((status) => {
    const count = levels.filter((level) => level.status === status).length;
    return count === 0 ? null : `${count} ${STATUS_WORDS[status]}`;
  });
  return counts.filter((text) => text !== null).join(', ');
}

/** Levels that could be completed and cannot any more, and the other way round. */
export function turnsInWords(levels: readonly DiffedLevel[]): string[] {
  const isDone = (version: JudgedVersion | null): boolean => version?.verdict === 'completable';
  const both = levels.filter(({ before, after }) => before !== null && after !== null);
  const lost = both.filter(({ before, after }) => isDone(before) && !isDone(after)).length;
  const won = both.filter(({ before, after }) => !isDone(before) && isDone(after)).length;
  return [
    ...(lost > 0 ? [`${plural(lost, 'level')} no longer completable`] : []),
    ...(won > 0 ? [`${plural(won, 'level')} now completable`] : []),
  ];
}

/** The whole diff, for people. */
export function diffText(diff: Diff, colors: Colors): string {
  const { levels, same, comparison } = diff;
  const rules = rulesInWords(diff);
  let text = '';
  if (rules.length > 0) {
    text += `${colors.bold('gq.config.json')}  rules changed, which changes how every level plays: ${rules.join(', ')}\n\n`;
  }
  const others = termsChangesInWords(diff);
  if (others.length > 0) {
    text += `${colors.bold('gq.config.json')}  terms changed, under which every level is judged: ${others.join(', ')}\n\n`;
  }
  for (const level of levels) text += `${levelText(level, colors)}\n`;
  const sides = `${comparison.before.label} -> ${comparison.after.label}`;
  if (levels.length === 0) return `${text}${visibleLine(sides)}: no level changed\n`;
  const rest = same > 0 ? `; ${plural(same, 'other level')} ${same === 1 ? 'plays' : 'play'} as before` : '';
  const [lost] = turnsInWords(levels);
  const turns = turnsInWords(levels).map((turn) => (turn === lost && turn.includes('no longer') ? colors.red(turn) : turn));
  return `${text}${visibleLine(sides)}: ${countsInWords(levels)}${turns.length > 0 ? `; ${turns.join(', ')}` : ''}${rest}\n`;
}

const MARKS: Readonly<Record<DiffStatus, string>> = {
  changed: '~',
  added: '+',
  removed: '-',
  renamed: '>',
  layout: '=',
  rules: '~',
};

function levelText(level: DiffedLevel, colors: Colors): string {
  const { status, after, before } = level;
  const paint = { added: colors.green, removed: colors.red, changed: colors.yellow }[status as string] ?? colors.cyan;
  const name = (after ?? before)?.name ?? '';
  const head = `${paint(MARKS[status])} ${colors.bold(visibleLine(pathInWords(level)))}  ${colors.dim(`${visibleLine(name)}, ${status}`)}\n`;
  const lines = linesOf(level).map((line) => `    ${visibleLine(line)}\n`);
  const effects = level.effects.map((line) => `    ${paintEffect(line, level, colors)}\n`);
  return head + lines.join('') + effects.join('');
}

function paintEffect(line: string, { before, after }: DiffedLevel, colors: Colors): string {
  const shown = `=> ${visibleLine(line)}`;
  if (after === null || before?.verdict === after.verdict) return colors.dim(shown);
  return after.verdict === 'completable' ? colors.green(shown) : colors.red(shown);
}
