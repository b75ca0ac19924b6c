import type { DiffReport } from '../../../schema/index.ts';
import type { Diff, DiffedLevel, JudgedVersion } from '../../diff/index.ts';
import { problemJson } from '../../report-parts/index.ts';

/** The diff as JSON. */
export function diffJson({ comparison, rules, levels, same }: Diff): string {
  const report: DiffReport = {
    version: 1,
    before: comparison.before.label,
    after: comparison.after.label,
    rules: rules.map(({ rule, before = null, after = null }) => ({ rule, before, after })),
    levels: levels.map(levelJson),
    same,
  };
  return `${JSON.stringify(report)}\n`;
}

const levelJson = ({ status, before, after, changes, words, effects }: DiffedLevel): DiffReport['levels'][number] => ({
  file: (after ?? before)?.file ?? '',
  status,
  words: [...words],
  effects: [...effects],
  before: before === null ? null : versionJson(before),
  after: after === null ? null : versionJson(after),
  changes: changes === null ? null : (changes as DiffReport['levels'][number]['changes']),
});

function versionJson({
  file,
  name,
  terms,
  verdict,
  problems,
  standing,
}: JudgedVersion): NonNullable<DiffReport['levels'][number]['before']> {
  const run = standing?.run ?? null;
  return {
    file,
    name,
    terms,
    verdict,
    problems: problems.map(problemJson),
    mineralCount: standing?.mineralCount ?? null,
    run:
      run === null
        ? null
        : {
            name: run.name,
            holds: run.holds.map(([press, release]) => [press, release]),
            outcome: run.outcome,
            with: run.with,
            time: run.time,
            tick: run.tick,
            minerals: run.minerals,
            clearance: run.clearance,
            slack: run.slack === null ? null : run.slack.edges.map(([earlier, later]) => [earlier, later]),
            smallestWindow: run.slack?.smallestWindow ?? null,
          },
  };
}
