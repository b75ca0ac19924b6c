import type { CheckedLevel } from '../../../cli/check/checked-level.ts';
import { totalsOf } from '../../../cli/check/index.ts';
import type { ShownProblem } from '../../../cli/report-parts/index.ts';
import type { ReportContext, Results } from '../../../cli/reporters/reporter.ts';
import { PLAIN } from '../../../cli/terminal/terminal.ts';
import { DEFAULT_TERMS } from '../../../engine/index.ts';

/** What reporters are given where a test does not care. */
export const CONTEXT: ReportContext = {
  colors: PLAIN,
  width: null,
  version: '1.2.3',
  terms: DEFAULT_TERMS,
  exitCode: 1,
  linkTo: null,
  places: { directory: '/project', workspaces: [], root: '/project' },
  isJenkins: false,
};

/** The results of a check that was not interrupted. */
export const resultsOf = (levels: readonly CheckedLevel[], rest: Partial<Results> = {}): Results => ({
  levels,
  totals: totalsOf(levels),
  unchecked: [],
  interrupted: false,
  ...rest,
});

/** A level that is completable. */
export const checkedLevel = (changes: Partial<CheckedLevel> = {}): CheckedLevel => ({
  file: 'levels/a.level.json',
  name: 'A',
  terms: { accuracy: 'precise', maxTime: 60, maxWork: 400_000, rules: {} },
  verdict: 'completable',
  run: { name: 'solution', outcome: 'completed', time: 2, tick: 120, minerals: [], clearance: null },
  found: null,
  report: null,
  mineralCount: 0,
  problems: [],
  unreadable: false,
  ms: 1.25,
  ...changes,
});

/** A level with a run that collides. */
export const brokenLevel = (changes: Partial<CheckedLevel> = {}): CheckedLevel =>
  checkedLevel({
    verdict: 'broken',
    run: { name: 'solution', outcome: 'collided', time: 2, tick: 120, minerals: [], clearance: null },
    problems: [shownProblem({ code: 'run-does-not-complete', pointer: '/runs/0', line: 9, column: 5 })],
    ...changes,
  });

export const shownProblem = (changes: Partial<ShownProblem> = {}): ShownProblem => ({
  code: 'unknown-key',
  severity: 'error',
  message: 'unknown key "asteriods"',
  hint: 'Write "asteroids".',
  pointer: '',
  line: 3,
  column: 7,
  frame: null,
  ...changes,
});
