import { compile, type Run, simulate } from '../../engine/index.ts';
import { type Level, type Problem, readLevel } from '../../schema/index.ts';
import { showProblems } from '../code-frames.ts';
import { Failure } from '../failure.ts';
import { type OpenedLevel, placed, warningsOf } from '../level-source.ts';
import { readBytes } from '../read-bytes.ts';
import { reportRun } from '../run-report.ts';
import { hangsOnAccuracy } from './accuracy-hang.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';
import { crashedLevel, refusedLevel, unreadableLevel } from './refused-level.ts';
import { failedRun, mineralLost } from './run-problems.ts';
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
  const { accuracy, maxTime, inFull } = settings;
  const scene = compile(level, accuracy);
  const scripted = level.runs.map(({ holds }) => simulate(scene, holds, { maxTime }));
  const first = scripted.findIndex((run) => run.outcome === 'completed');
  const beyond = first >= 0 ? null : judgeWithoutRun(file, scene, settings);
  const found = beyond?.found ?? null;
  const verdict = first >= 0 ? 'completable' : (beyond?.verdict ?? 'broken');

  const problems: Problem[] = [];
  const add = (problem: Omit<Problem, 'line' | 'column'>) => problems.push(placed(problem, document));
  for (const problem of beyond?.problems ?? []) add(problem);
  for (const [index, run] of scripted.entries()) {
    if (run.outcome === 'completed') continue;
    add(failedRun({ file, level, accuracy: accuracy.name, index, run, noneCompletes: verdict !== 'completable' }));
  }
  for (const problem of hangsOnAccuracy(file, level, scripted, accuracy, maxTime)) add(problem);
  const completing = completingRuns(level, scripted, found);
  for (const problem of slackProblems(scene, completing, settings)) add(problem);
  const lost = mineralsLost(level, scripted, found?.run ?? null, settings);
  for (const mineral of lost) add(mineralLost(mineral));

  const shown = found ?? chosen(level, scripted, Math.max(first, 0));
  const proved = new Set(lost.map(({ index }) => `/minerals/${index}`));
  // what is proved need not be warned of, too
  const isOutdone = (code: string, pointer: string): boolean =>
    code === beyond?.outdone || (/^mineral-(?:out-of-reach|covered)$/.test(code) && proved.has(pointer));
  const warnings = warningsOf(opened, found === null ? scripted : [...scripted, found.run]);
  return {
    file,
    name: level.name,
    verdict,
    run: shown === null ? null : { time: shown.run.time, minerals: [...shown.run.minerals], clearance: shown.run.clearance },
    found: found?.holds ?? null,
    report: shown === null || !inFull ? null : reportRun(level, accuracy.name, shown.holds, shown.run, null),
    mineralCount: level.minerals.length,
    problems: [
      ...(problems.length > 0 ? showProblems(problems, document.text) : []),
      ...warnings.filter(({ code, pointer }) => !isOutdone(code, pointer)),
    ],
    unreadable: false,
    ms: 0,
  };
}

const chosen = ({ runs }: Level, played: readonly Run[], index: number): PlayedRun | null =>
  runs.length === 0 ? null : { holds: runs[index].holds, run: played[index] };
