import {
  accuracyInWords,
  effortInWords,
  outcomeInWords,
  plural,
  proposalInWords,
  proposalRunInWords,
  SIZE_MEANS,
} from '../../../check/words/index.ts';
import type { Level } from '../../../schema/index.ts';
import { type Colors, visible, visibleLine } from '../../io/index.ts';
import type { Fixed, FixSettings } from './fixed.ts';

/** What `gq fix` prints for people. */
export function fixPretty(level: Level, { terms, seed }: FixSettings, fixed: Fixed, colors: Colors): string {
  const { verdict, completing, impossible, fixes, effort, seconds, isFinished } = fixed;
  const head = `${colors.bold(visibleLine(level.name))}, ${accuracyInWords(terms)}: ${verdict}`;
  if (completing !== null) {
    return `${head}\nnothing to fix: run ${JSON.stringify(visibleLine(level.runs[completing].name))} completes the level\n`;
  }
  const why = impossible === null ? '' : `${visible(impossible.reason)}\n`;
  const spent = `effort  ${effortInWords(effort)}, ${seconds.toFixed(1)} s, seed ${seed}\n`;
  if (fixes.length === 0) {
    const more = isFinished ? 'no single change of those that were tried is enough' : 'a larger --budget or --effort tries more';
    return `${head}\n${why}${colors.yellow('no fix found')}: ${more}\n\n${spent}`;
  }
  const parts = fixes.map(({ proposal, run }, i) => {
    const size = proposal.change === null ? 'the level stays as it is' : `${proposal.size.toFixed(1)} px`;
    return (
      `${colors.bold(`${i + 1}`)}  ${colors.green(visibleLine(proposalInWords(level, proposal)))}\n` +
      `   ${size}; ${visibleLine(proposalRunInWords(level, proposal))}: ${outcomeInWords(run, level.range)}\n`
    );
  });
  const found = `${plural(fixes.length, 'proposal')}, each the smallest that was found of its kind. ${SIZE_MEANS}`;
  return `${head}\n${why}\n${parts.join('')}\n${found}\n${spent}`;
}
