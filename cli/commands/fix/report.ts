import {
  accuracyInWords,
  effortInWords,
  outcomeInWords,
  plural,
  proposalInWords,
  proposalRunInWords,
  SIZE_MEANS,
  termsReport,
} from '../../../check/words/index.ts';
import { type FixReport, type Level, listOf } from '../../../schema/index.ts';
import { changeEdits, type ObjectRef } from '../../../solver/index.ts';
import { type Colors, visible, visibleLine } from '../../terminal/index.ts';
import type { Fixed, FixedFile, FixSettings } from './fixed.ts';

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

/** What `gq fix` prints as JSON. @param written the number of the proposal that is in the file now */
export function fixReport(level: Level, { terms, seed }: FixSettings, fixed: Fixed, written: number | null): FixReport {
  const { verdict, completing, impossible, fixes, effort, seconds, isFinished } = fixed;
  return {
    version: 1,
    level: level.name,
    accuracy: terms.accuracy.name,
    terms: termsReport({ terms, level }),
    verdict,
    completedBy: completing === null ? null : level.runs[completing].name,
    impossible: impossible === null ? null : { code: impossible.code, reason: impossible.reason },
    proposals: fixes.map((fix) => proposalJson(level, fix)),
    effort: { ...effort, seconds, seed },
    isFinished,
    written,
  };
}

function proposalJson(level: Level, { proposal, run }: FixedFile): FixReport['proposals'][number] {
  const { change, size, origin } = proposal;
  const object = change === null || change.what === 'range' ? null : change.what === 'velocity' ? START : change.object;
  return {
    kind: change?.what ?? 'run',
    object: object === null ? null : { ...object, id: idOf(level, object) },
    size,
    words: proposalInWords(level, proposal),
    edits: (change === null ? [] : changeEdits(change)).map(({ path, value }) => {
      const from = path.reduce<unknown>((at, key) => (at as Readonly<Record<string | number, unknown>>)[key], level);
      return { pointer: `/${path.join('/')}`, from: typeof from === 'number' ? from : null, to: value };
    }),
    run: {
      origin: origin.from,
      name: origin.from === 'search' ? null : level.runs[origin.index].name,
      shifted: origin.from === 'adjusted' ? origin.ticks : null,
      holds: proposal.run.holds.map(([press, release]) => [press, release]),
      tick: run.tick,
      time: run.time,
      minerals: [...proposal.run.minerals],
      hash: run.hash,
    },
  };
}

const START: ObjectRef = { kind: 'astronaut', index: 0 };

function idOf(level: Level, { kind, index }: ObjectRef): string | null {
  if (kind === 'astronaut' || kind === 'blackHole') return null;
  return level[listOf(kind)][index].id;
}
