import { basename } from 'node:path';
import { type AccuracyName, compile, type Run, simulate } from '../../engine/index.ts';
import { type Level, type Problem, readLevel, type ScriptedRun } from '../../schema/index.ts';
import { Failure } from '../failure.ts';
import { readBytes } from '../files.ts';
import { type OpenedLevel, placed, warningsOf } from '../level-source.ts';
import { outcomeInWords } from '../outcome.ts';
import { type ShownProblem, showProblems } from '../problem.ts';
import { reportRun } from '../run-report.ts';
import type { CheckedLevel, CheckSettings } from './checked-level.ts';

/** Reads and validates one level file and replays its scripted runs in order. Never throws: what goes wrong is a verdict. */
export function checkLevel(file: string, settings: CheckSettings): CheckedLevel {
  const start = performance.now();
  const report = judge(file, settings);
  return { ...report, ms: performance.now() - start };
}

function judge(file: string, settings: CheckSettings): CheckedLevel {
  try {
    const read = readLevel(readBytes(file));
    return read.ok ? replay(file, read, settings) : refuse(file, 'invalid', showProblems(read.problems, read.text));
  } catch (error) {
    return error instanceof Failure ? unreadableLevel(file, error.message) : crashedLevel(file, error);
  }
}

/** The report of a file that can't be read. */
export function unreadableLevel(file: string, message: string): CheckedLevel {
  const hint = 'nothing is known of this level: make the file readable, or leave it out';
  return { ...refuse(file, 'invalid', [problemOfFile('unreadable-file', message, hint)]), unreadable: true };
}

/** The report of a level on which the toolkit itself fell over. */
export function crashedLevel(file: string, error: unknown): CheckedLevel {
  const message = `checking this level crashed: ${error instanceof Error ? error.message : String(error)}`;
  return refuse(file, 'crashed', [
    problemOfFile('crashed', message, 'this is a bug in gq: please report it with the level file'),
  ]);
}

const problemOfFile = (code: string, message: string, hint: string): ShownProblem => ({
  code,
  severity: 'error',
  message,
  hint,
  pointer: '',
  line: null,
  column: null,
  frame: null,
});

function refuse(file: string, verdict: 'invalid' | 'crashed', problems: readonly ShownProblem[]): CheckedLevel {
  return {
    file,
    name: basename(file).replace(/(\.level)?\.json$/, ''),
    verdict,
    run: null,
    mineralCount: 0,
    problems,
    unreadable: false,
    ms: 0,
  };
}

function replay(file: string, opened: OpenedLevel, settings: CheckSettings): CheckedLevel {
  const { level, document } = opened;
  const scene = compile(level, settings.accuracy as AccuracyName);
  const played = level.runs.map((script) => ({ script, run: simulate(scene, script.holds, { maxTime: settings.maxTime }) }));
  const runs = played.map(({ run }) => run);
  const best = played.find(({ run }) => run.outcome === 'completed') ?? played[0];
  const verdict = best === undefined ? 'unproven' : best.run.outcome === 'completed' ? 'completable' : 'broken';

  const problems: Problem[] = [];
  if (best === undefined) problems.push(noRun);
  for (const [i, { script, run }] of played.entries()) {
    if (run.outcome !== 'completed')
      problems.push(placed(failedRun(file, level, i, script, run, verdict === 'broken'), document));
  }
  return {
    file,
    name: level.name,
    verdict,
    run: best === undefined ? null : reportRun(level, settings.accuracy, best.script.holds, best.run, null),
    mineralCount: level.minerals.length,
    problems: [...(problems.length > 0 ? showProblems(problems, document.text) : []), ...warningsOf(opened, runs)],
    unreadable: false,
    ms: 0,
  };
}

const noRun: Problem = {
  code: 'no-run',
  severity: 'error',
  message: 'the level has no run, so nothing shows that it can be completed',
  hint: 'add a run that completes it: "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s',
  pointer: '',
  line: null,
  column: null,
};

function failedRun(
  file: string,
  level: Level,
  index: number,
  script: ScriptedRun,
  run: Run,
  noneCompletes: boolean,
): Omit<Problem, 'line' | 'column'> {
  const again = `see gq simulate ${/^[\w./\\:-]+$/.test(file) ? file : JSON.stringify(file)} --run ${JSON.stringify(script.name)}`;
  return {
    code: 'run-does-not-complete',
    severity: noneCompletes ? 'error' : 'warning',
    message: `run ${JSON.stringify(script.name)} does not complete the level: ${outcomeInWords(run, level)}`,
    hint: noneCompletes
      ? `move what is in the way or change the run; ${again}`
      : `another run does; mend this one or take it out; ${again}`,
    pointer: `/runs/${index}`,
  };
}
