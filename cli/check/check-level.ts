import { compile, DEFAULT_MAX_WORK, type Run, simulate, WorkBudget, WorkLimitReached } from '../../engine/index.ts';
import { type Level, type Problem, readLevel } from '../../schema/index.ts';
import { showProblems } from '../code-frames.ts';
import { Failure } from '../failure.ts';
import { type OpenedLevel, placed, warningsOf } from '../level-source.ts';
import { readBytes } from '../read-bytes.ts';
import { plural } from '../report-parts/index.ts';
import { reportRun } from '../run-report.ts';
import { hangsOnAccuracy } from './accuracy-hang.ts';
import type { CheckedLevel, CheckSettings, RunInBrief } from './checked-level.ts';
import { crashedLevel, refusedLevel, unreadableLevel } from './refused-level.ts';
import { failedRun, mineralLost, workLimit } from './run-problems.ts';
import { completingRuns, slackProblems } from './slack-problems.ts';
import { judgeWithoutRun, mineralsLost, type PlayedRun } from './without-run.ts';

/** Reads and validates one level file and replays its scripted runs in order. Never throws: what goes wrong is a verdict. */
export function checkLevel(file: string, settings: CheckSettings): CheckedLevel {
  const start = performance.now();
  const report = judge(file, settings);
  return { ...report, ms: performance.now() - start };
}

function judge(file: string, settings: CheckSettings): CheckedLevel {
  try {
    const read = readLevel(readBytes(file));
    return read.ok ? replay(file, read, settings) : refusedLevel(file, 'invalid', showProblems(read.problems, read.text));
  } catch (error) {
    return error instanceof Failure ? unreadableLevel(file, error.message) : crashedLevel(file, error);
  }
}

function replay(file: string, opened: OpenedLevel, settings: CheckSettings): CheckedLevel {
  const { level, document } = opened;
  const { accuracy, maxTime, inFull, maxWork = DEFAULT_MAX_WORK } = settings;
  // a budget for each part of a check, so that none of them starves another
  const budget = new WorkBudget(maxWork);
  const scene = compile(level, accuracy);
  const scripted = level.runs.map(({ holds }, index) => simulate(scene, holds, { maxTime, budget, record: index === 0 }));
  const first = scripted.findIndex((run) => run.outcome === 'completed');
  const unplayed = scripted.findIndex((run) => run.stopped !== null);
  const proofs = new WorkBudget(maxWork / 2);
  const beyond = first >= 0 ? null : judgeWithoutRun(file, scene, settings, unplayed < 0, proofs);
  const found = beyond?.found ?? null;
  const verdict = first >= 0 ? 'completable' : (beyond?.verdict ?? 'broken');

  const problems: Problem[] = [];
  const add = (problem: Omit<Problem, 'line' | 'column'>) => problems.push(placed(problem, document));
  for (const problem of beyond?.problems ?? []) add(problem);
  if (unplayed >= 0) {
    const name = JSON.stringify(level.runs[unplayed].name);
    const more = scripted.filter((run) => run.stopped !== null).length - 1;
    const others = more > 0 ? `, and ${plural(more, 'run')} after it not at all` : '';
    const what = `run ${name} was not played beyond tick ${scripted[unplayed].tick}${others}`;
    add(workLimit({ what, pointer: `/runs/${unplayed}` }, budget, verdict === 'unproven'));
  }
  for (const [index, run] of scripted.entries()) {
    if (run.outcome === 'completed' || run.stopped !== null) continue;
    add(failedRun({ file, level, accuracy: accuracy.name, index, run, noneCompletes: verdict !== 'completable' }));
  }
  const others = new WorkBudget(maxWork / 2);
  const hangs = unplayed >= 0 ? [] : withinWork(others, () => hangsOnAccuracy(file, level, scripted, accuracy, maxTime, others));
  for (const problem of hangs ?? []) add(problem);
  if (hangs === null)
    add(workLimit({ what: 'whether its runs complete it at every accuracy was not looked at', pointer: '/runs' }, others, false));
  const completing = completingRuns(level, scripted, found);
  for (const problem of slackProblems(scene, completing, settings)) add(problem);
  const lost = mineralsLost(level, scripted, found?.run ?? null, settings, proofs);
  for (const mineral of lost) add(mineralLost(mineral));

  const shown = found ?? chosen(level, scripted, Math.max(first, 0));
  const proved = new Set(lost.map(({ index }) => `/minerals/${index}`));
  // what is proved need not be warned of, too
  const isOutdone = (code: string, pointer: string): boolean =>
    code === beyond?.outdone || (/^mineral-(?:out-of-reach|covered)$/.test(code) && proved.has(pointer));
  // a run that was stopped, or of which too much would be asked, is not told in full
  const brief = shown === null || shown.run.stopped !== null ? null : withinWork(budget, () => inBrief(shown.run));
  const report =
    brief === null || shown === null || !inFull
      ? null
      : withinWork(budget, () => reportRun(level, accuracy.name, shown.holds, shown.run, null));
  const looked = withinWork(budget, () => warningsOf(opened, played(found === null ? scripted : [...scripted, found.run])));
  const warnings = looked ?? warningsOf(opened, []);
  if (unplayed < 0 && budget.isUsedUp) {
    add(workLimit({ what: 'what its runs come near to was not looked at', pointer: '/runs' }, budget, false));
  }
  return {
    file,
    name: level.name,
    verdict,
    run: brief,
    found: found?.holds ?? null,
    report,
    mineralCount: level.minerals.length,
    problems: [
      ...(problems.length > 0 ? showProblems(problems, document.text) : []),
      ...warnings.filter(({ code, pointer }) => !isOutdone(code, pointer)),
    ],
    unreadable: false,
    ms: 0,
  };
}

const played = (runs: readonly Run[]): Run[] => runs.filter((run) => run.stopped === null);

const inBrief = ({ time, minerals, clearance }: Run): RunInBrief => ({ time, minerals: [...minerals], clearance });

/** What some work comes to; null where it takes more than is left. */
function withinWork<T>(budget: WorkBudget, work: () => T): T | null {
  try {
    return budget.isUsedUp ? null : work();
  } catch (error) {
    if (error instanceof WorkLimitReached) return null;
    throw error;
  }
}

const chosen = ({ runs }: Level, played: readonly Run[], index: number): PlayedRun | null =>
  runs.length === 0 ? null : { holds: runs[index].holds, run: played[index] };
