import { isAscii } from 'node:buffer';
import {
  atOnce,
  type Brief,
  brief,
  completingRuns,
  examineInSteps,
  type Findings,
  findingsOf,
  type Hints,
  mineralsToProve,
  problemsOf,
  proveMineralsLost,
  type Searched,
  type Softlocks,
  softlocksOf,
  ticksToAgree,
  tightRuns,
  verdictOfFindings,
  withinWork,
} from '../../check/index.ts';
import { termsReport } from '../../check/words/index.ts';
import { isAccuracyName, type Run, type Scene, simulate, type Terms, termsOf, WorkBudget } from '../../engine/index.ts';
import {
  codeFrame,
  conflictProblems,
  type Hold,
  type Level,
  type Problem,
  readLevel,
  type ScriptedRun,
  type SoftlockReport,
} from '../../schema/index.ts';
import { createSoftlockSurvey, type Proof, type SoftlockSurvey, type Steps } from '../../solver/index.ts';
import { readBytes } from '../io/index.ts';
import { decideWithin, type OpenedLevel, placed, reportRun } from '../levels/index.ts';
import { byHolds, showProblems } from '../report-parts/index.ts';
import { Failure, shellPath } from '../terminal/index.ts';
import {
  type CheckedLevel,
  type CheckSettings,
  crashedLevel,
  type RunInBrief,
  refusedLevel,
  type SearchSettings,
  unreadableLevel,
  withKeys,
} from './checked-level.ts';
import { ANYWHERE, atFile, type KeptLevel, keptLevel, mayMention } from './level-cache.ts';

/** The report for a file. */
export interface CheckedFile {
  readonly level: CheckedLevel;
  /** What the cache is to keep; null if it has no use for it. */
  readonly kept: KeptLevel | null;
}

/**
 * Reads and validates one level file and replays its runs in order. Never throws: errors become verdicts.
 * @param content in place of what the file has
 */
export const checkLevel = (file: string, settings: CheckSettings, content?: Uint8Array): CheckedLevel =>
  checkTogether([{ file, content }], settings, null)[0].level;

/** A file to check. */
export interface GivenFile {
  readonly file: string;
  /** In place of what the file has. */
  readonly content?: Uint8Array;
}

/**
 * Checks several files: a step of each, then the next step. So the code of a step stays in the caches of the processor, which
 * is faster than one file after the other.
 * @returns a report for each file, in their order
 */
export function checkTogether(files: readonly GivenFile[], asked: CheckSettings, cacheKey: string | null): CheckedFile[] {
  // another thread has sent a copy of the accuracy, which would be examined again for each level
  const settings: CheckSettings = { ...asked, terms: termsOf(asked.terms) };
  const reports: CheckedFile[] = [];
  for (let first = 0; first < files.length; first += AT_ONCE) {
    const some = files.slice(first, first + AT_ONCE);
    const going = some.map((given, i) => {
      const clock = { ms: 0, since: 0 };
      return { i, clock, steps: checkInSteps(given, settings, cacheKey, clock) };
    });
    let now = performance.now();
    for (let rest = going; rest.length > 0; ) {
      rest = rest.filter(({ i, clock, steps }) => {
        clock.since = now;
        const step = steps.next();
        now = performance.now();
        clock.ms += now - clock.since;
        if (step.done === true) reports[first + i] = step.value;
        return step.done !== true;
      });
    }
  }
  return reports;
}

/** Files that are checked together: with more, the collector of garbage has more to copy. */
const AT_ONCE = 16;

/** The time that a check has taken: the ms of its steps so far, and when the present one began. */
interface Clock {
  ms: number;
  since: number;
}

const taken = ({ ms, since }: Clock): number => ms + performance.now() - since;

function* checkInSteps(
  { file, content }: GivenFile,
  settings: CheckSettings,
  cacheKey: string | null,
  clock: Clock,
): Steps<CheckedFile> {
  try {
    const bytes = content ?? readBytes(file);
    const { level, isAnywhere, isSettled } = yield* judge(file, bytes, settings);
    const whole = Object.assign(level, { ms: taken(clock) });
    return {
      level: isAnywhere ? atFile(whole, file) : whole,
      kept: cacheKey !== null && isAnywhere && isSettled ? keptLevel(cacheKey, bytes, whole) : null,
    };
  } catch (error) {
    const level =
      error instanceof Failure ? unreadableLevel(file, error.message, settings.terms) : crashedLevel(file, error, settings.terms);
    return { level: { ...level, ms: taken(clock) }, kept: null };
  }
}

/** Bytes of a file and pieces of its runs up to which it waits for others between two steps: many may wait at once. */
const LIGHT = { bytes: 64 * 1024, pieces: 2000 };

/** The text of bytes that are certainly one: native code decodes it in a fraction of the time. NUL makes another kind of file. */
function textOf(bytes: Uint8Array): Uint8Array | string {
  if (!isAscii(bytes) || bytes[0] !== 0x7b || bytes.includes(0)) return bytes;
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.length).toString('latin1');
}

interface Judgement {
  readonly level: CheckedLevel;
  /** Whether the level is as it would be for a file in another place, with `ANYWHERE` for its path. */
  readonly isAnywhere: boolean;
  /** Whether the same bytes always get the same report, whatever the speed of the machine. */
  readonly isSettled: boolean;
}

function* judge(file: string, bytes: Uint8Array, settings: CheckSettings): Steps<Judgement> {
  const { terms } = settings;
  const read = readLevel(textOf(bytes), terms);
  if (!read.ok) return refused(file, read.problems, read.text, terms);
  const undecided = conflictProblems(read.document.file, read.document.locate);
  if (undecided.length > 0) return refused(file, undecided, read.document.text, terms);
  if (bytes.length > LIGHT.bytes) return atOnce(replay(file, read, settings));
  yield null;
  return yield* replay(file, read, settings);
}

function refused(file: string, problems: readonly Problem[], text: string, terms: Terms): Judgement {
  const level = refusedLevel(file, 'invalid', withKeys(showProblems(problems, text), text), terms);
  return { level, isAnywhere: true, isSettled: true };
}

function* replay(file: string, { level, document }: OpenedLevel, settings: CheckSettings): Steps<Judgement> {
  const { terms, requireSlack, search } = settings;
  const judged = brief(level, terms);
  const { scene, runs: scripted, budget, proofs } = judged;
  const isLight = scripted.reduce((sum, { work }) => sum + work.pieces, 0) <= LIGHT.pieces;
  if (isLight) yield null;
  const completing = scripted.findIndex(({ outcome }) => outcome === 'completed');
  const { impossible, searched, found } = completing >= 0 ? NOT_NEEDED : withoutRun(judged, settings);

  const examined = examineInSteps(level, scripted, { scene, budget, found: found?.run });
  const runs = isLight ? yield* examined : atOnce(examined);
  if (isLight) yield null;
  // after the examination, so that what is found does not depend on the form of the report
  const shown = found ?? chosen(level.runs, scripted, judged.shown ?? 0);
  const { run: shownRun, report } = inWords(scene, shown, settings, budget);
  const isSlackAskedFor = requireSlack !== null || search !== null;
  const asked = settings.proveMinerals ? mineralsToProve(level, runs.collected) : [];
  const isCompleted = completing >= 0 || found !== null;
  const survey = settings.softlocks !== undefined && isCompleted ? surveyLost(scene, settings.softlocks, found?.holds) : null;
  const findings = findingsOf(runs, {
    softlocks: survey === null ? null : softlocksOf(survey),
    impossible,
    searched,
    // measuring slack takes long: only on request
    tight: isSlackAskedFor ? tightRuns(scene, completingRuns(level, scripted, found?.holds ?? null), requireSlack) : [],
    sought: {
      slack: requireSlack === null ? (search === null ? null : 'low') : requireSlack > 0 ? 'required' : null,
      minerals: settings.proveMinerals && isAccuracyName(terms.accuracy.name),
      softlocks: survey !== null,
    },
    lost: proveMineralsLost(scene, asked, proofs),
  });
  const run = settings.forLock && shownRun !== null ? { ...shownRun, ...lockedRun(scene, shown!, document, budget) } : shownRun;
  const isAnywhere = !mayMention(document.text);
  const hints = isAnywhere ? HINTS_ANYWHERE : commandHints(shellPath(file));
  const problems = problemsOf(findings, hints).map((problem) => placed(problem, document));
  const checked: CheckedLevel = {
    file,
    name: level.name,
    terms: termsReport(scene),
    verdict: verdictOfFindings(findings),
    run,
    found: found?.holds ?? null,
    report,
    mineralCount: level.minerals.length,
    ...optionalParts(level, findings, settings),
    problems: problems.length > 0 ? withKeys(showProblems(problems, document.text), document.text, document.file) : [],
    unreadable: false,
    ms: 0,
  };
  return { level: checked, isAnywhere, isSettled: searched?.isOutOfTime !== true };
}

const NO_PARTS = {};

/** The members of a report that few levels have. */
function optionalParts(
  level: Level,
  findings: Findings,
  { softlocks }: CheckSettings,
): Pick<CheckedLevel, 'softlocks' | 'allow'> {
  if (softlocks === undefined && level.allow === undefined) return NO_PARTS;
  return {
    ...(softlocks !== undefined && {
      softlocks: findings.softlocks === null ? null : softlockReport(findings.softlocks, level),
    }),
    ...(level.allow !== undefined && { allow: level.allow }),
  };
}

/** Holds and their simulated run. */
interface PlayedRun {
  /** The name of the run in the file; null if a search found it. */
  readonly name: string | null;
  readonly holds: readonly Hold[];
  readonly run: Run;
}

/** Examines where the level is already lost. @param found a run that a search found, besides those of the level */
function surveyLost(scene: Scene, ticks: number, found: readonly Hold[] | undefined): SoftlockSurvey {
  const own = scene.level.runs.map(({ holds }) => holds);
  const survey = createSoftlockSurvey(scene, { runs: found === undefined ? own : [...own, found] });
  survey.advance(ticks);
  return survey;
}

interface WithoutRun {
  readonly impossible: Proof | null;
  readonly searched: LevelSearch | null;
  readonly found: PlayedRun | null;
}

const NOT_NEEDED: WithoutRun = { impossible: null, searched: null, found: null };

/** For a level that none of its own runs completes, and that is perhaps proved to be impossible: searches on request. */
function withoutRun({ scene, impossible }: Brief, settings: CheckSettings): WithoutRun {
  const { search } = settings;
  if (impossible !== null || search === null) return { ...NOT_NEEDED, impossible };
  const searched = search.claimed === undefined ? searchLevel(scene, search, settings) : unsearched(search.claimed);
  if (searched.found === null) return { ...NOT_NEEDED, impossible: searched.impossible, searched };
  const holds = searched.found;
  const run = simulate(scene, holds, { budget: new WorkBudget(scene.terms.maxWork) });
  // a run of the file that costs as much proves nothing either
  if (run.stopped !== null || (search.claimed !== undefined && run.outcome !== 'completed'))
    return { ...NOT_NEEDED, searched: { ...searched, found: null } };
  if (run.outcome !== 'completed') throw new Error(`a run that was found does not complete the level: ${JSON.stringify(holds)}`);
  return { impossible, searched, found: { name: null, holds, run } };
}

/** A search that was done elsewhere. */
const unsearched = (found: readonly Hold[]): LevelSearch => ({
  found,
  impossible: null,
  effort: { runs: 0, ticks: 0 },
  closest: null,
  isOutOfTime: false,
});

const chosen = (runs: readonly ScriptedRun[], played: readonly Run[], index: number): PlayedRun | null =>
  runs.length === 0 ? null : { name: runs[index].name, holds: runs[index].holds, run: played[index] };

/** The shown run, in brief and on request in full; null if the run was stopped or a report would cost too much work. */
function inWords(
  scene: Scene,
  shown: PlayedRun | null,
  { inFull }: CheckSettings,
  budget: WorkBudget,
): Pick<CheckedLevel, 'run' | 'report'> {
  if (shown === null || shown.run.stopped !== null) return { run: null, report: null };
  const run = withinWork(budget, () => inBrief(shown));
  if (run === null || !inFull) return { run, report: null };
  return { run, report: withinWork(budget, () => reportRun(scene, shown.holds, shown.run, null)) };
}

function inBrief({ name, run }: PlayedRun): RunInBrief {
  const { outcome, time, tick, minerals, clearance } = run;
  return { name, outcome, time, tick, minerals: [...minerals], clearance };
}

/** What a lock compares of the shown run, and where the run stands in the file. */
function lockedRun(
  scene: Scene,
  { name, holds, run }: PlayedRun,
  document: OpenedLevel['document'],
  budget: WorkBudget,
): Pick<RunInBrief, 'hash' | 'certifiedTicks' | 'place'> {
  const isCompleted = run.outcome === 'completed';
  const pointer = `/runs/${scene.level.runs.findIndex((one) => one.name === name)}`;
  return {
    hash: withinWork(budget, () => run.hash),
    certifiedTicks: isCompleted ? ticksToAgree(scene, holds) : null,
    place: name === null ? null : placeOf(pointer, document),
  };
}

function placeOf(pointer: string, { text, locate }: OpenedLevel['document']): NonNullable<RunInBrief['place']> {
  const { line, column } = locate(pointer);
  return { pointer, line, column, frame: codeFrame(text, line, column) };
}

/** Hints for the command line about the problems of a level file. @param path the file, quoted for a shell */
export function commandHints(path: string): Hints {
  return {
    firstRun: `find one with gq solve ${path} --write, or add "runs": [{ "name": "solution", "holds": [[press, release], ...] }], in ticks of 1/60 s`,
    seeRun: (name) => `; to see how it ends: gq simulate ${path} --run ${JSON.stringify(name)}`,
    seeAccuracies: (name) => `; to compare all accuracies: gq accuracy ${path} --run ${JSON.stringify(name)}`,
    moreWork: ', or allow more work with --max-work; gq explain work-limit says more',
    seeLost: `; to see where: gq render ${path} --softlocks -o lost.svg`,
    seeProof: `; to see why: gq render ${path} --proof -o proof.svg`,
    search: {
      keepFound: `: gq solve ${path} --write`,
      nothingFound: 'draw that run with gq render --holds, make the level easier, or search longer with --budget or gq solve',
      nearestRun: byHolds,
      tightRun:
        'give her more room where timing is tight (gq difficulty --run NAME shows the slack of each press and release), or find a run that forgives more with gq solve',
    },
  };
}

/** Those for nearly every level. */
const HINTS_ANYWHERE = commandHints(ANYWHERE);

/** What a search found. */
interface LevelSearch extends Searched {
  /** A proof that there is no run, found beside the search; null if there is none. */
  readonly impossible: Proof | null;
  /** Whether the clock ended it: another search with the same settings may find more or less. */
  readonly isOutOfTime: boolean;
}

/** Searches for any run that completes a level, or if slack is required, for the most robust one. */
function searchLevel(scene: Scene, { limits, seed }: SearchSettings, { requireSlack }: CheckSettings): LevelSearch {
  const decider = decideWithin(scene, limits, seed, requireSlack === null ? 'first' : 'robust');
  const { best, impossible, effort, closest, finished } = decider;
  return { found: best?.holds ?? null, impossible, effort: { ...effort }, closest, isOutOfTime: !finished };
}

/** Where a level is already lost, as reports have it. @param runs those of the level */
function softlockReport({ states, lasting, places, effort, isFinished }: Softlocks, { runs }: Level): SoftlockReport {
  return {
    states,
    lasting,
    places: places.map(({ x, y, tick, open, alive, states: beyond, run, holds, standing }) => ({
      x,
      y,
      tick,
      open,
      alive,
      states: beyond,
      run: run === null ? null : (runs[run]?.name ?? null),
      holds: holds.map(([press, release]) => [press, release]),
      known: standing.is === 'proved' ? 'proved' : 'not found',
      proof: standing.is === 'proved' ? { code: standing.proof.code, reason: standing.proof.reason } : null,
      searched: standing.is === 'not found' ? standing.ticks : null,
    })),
    effort,
    isFinished,
  };
}
