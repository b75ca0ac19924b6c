import { compile, simulate } from '../../engine/index.ts';
import { type Problem, readLevel } from '../../schema/index.ts';
import { showProblems } from '../code-frames.ts';
import { Failure } from '../failure.ts';
import { type OpenedLevel, placed, warningsOf } from '../level-source.ts';
import { readBytes } from '../read-bytes.ts';
import { reportRun } from '../run-report.ts';
import { hangsOnAccuracy } from './accuracy-hang.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';
import { crashedLevel, refusedLevel, unreadableLevel } from './refused-level.ts';
import { failedRun, NO_RUN } from './run-problems.ts';

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

function replay(file: string, opened: OpenedLevel, { accuracy, maxTime, inFull }: CheckSettings): CheckedLevel {
  const { level, document } = opened;
  const scene = compile(level, accuracy);
  const runs = level.runs.map(({ holds }) => simulate(scene, holds, { maxTime }));
  const first = runs.findIndex((run) => run.outcome === 'completed');
  const shown = Math.max(first, 0);
  const verdict = runs.length === 0 ? 'unproven' : first < 0 ? 'broken' : 'completable';

  const problems: Problem[] = [];
  if (verdict === 'unproven') problems.push(NO_RUN);
  for (const [index, run] of runs.entries()) {
    if (run.outcome === 'completed') continue;
    problems.push(
      placed(failedRun({ file, level, accuracy: accuracy.name, index, run, noneCompletes: verdict === 'broken' }), document),
    );
  }
  const run = runs.at(shown);
  for (const problem of hangsOnAccuracy(file, level, runs, accuracy, maxTime)) problems.push(placed(problem, document));
  return {
    file,
    name: level.name,
    verdict,
    run: run === undefined ? null : { time: run.time, minerals: [...run.minerals], clearance: run.clearance },
    report: run === undefined || !inFull ? null : reportRun(level, accuracy.name, level.runs[shown].holds, run, null),
    mineralCount: level.minerals.length,
    problems: [...(problems.length > 0 ? showProblems(problems, document.text) : []), ...warningsOf(opened, runs)],
    unreadable: false,
    ms: 0,
  };
}
