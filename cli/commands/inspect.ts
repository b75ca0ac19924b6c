import process from 'node:process';
import type { Command } from 'commander';
import { playRuns, withinWork } from '../../check/index.ts';
import { plural, termsReport } from '../../check/words/index.ts';
import {
  type ChosenEffect,
  compile,
  type EffectWork,
  type Mode,
  type Work,
  WorkBudget,
  workByEffect,
} from '../../engine/index.ts';
import { EFFECT_TIMING, timeByEffect } from '../../engine/work-precision/index.ts';
import {
  type InspectReport,
  isVariant,
  KINDS,
  type Level,
  LISTED_KINDS,
  type ListedKind,
  listOf,
  type TermsReport,
} from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { openLevel, warningsOf } from '../levels/index.ts';
import { addTermsOptions, formatOption, type TermsOptions, termsFrom } from '../options/index.ts';
import { alignColumns, problemJson, type ShownProblem, showFileProblems } from '../report-parts/index.ts';
import { type Colors, colorsFor, visibleLine, widthOf } from '../terminal/index.ts';

interface InspectOptions extends ConfigOptions, TermsOptions {
  readonly time?: true;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description: 'Show what a level calls for: which effects are simulated and which are not, with the reason; counts; warnings.',
  more: `
Work and modes are those of the level's first run, as far as --max-work lets it go, and so is what each effect costs: guards
that are followed, roots that are located, and events that happen. --time measures for two seconds what each of them takes
of the run's time on this machine. arcade does not tell these apart.

Exit code: 0; 1 when the level is invalid; 2 when it could not be read.

Examples:
  $ gq inspect levels/01-first-pull.level.json
  $ gq inspect levels/01-first-pull.level.json --time
  $ gq inspect levels/01-first-pull.level.json --format json | jq .effects.notCalledFor`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .argument('<level>', 'a level file')
    .option('--time', 'measure what each effect takes of the run')
    .addOption(formatOption('pretty', 'json'))
    .action(async (file: string, options: InspectOptions) => finish(await inspect(file, options)));
}

async function inspect(file: string, options: InspectOptions): Promise<CommandResult> {
  const terms = termsFrom(options, await readConfiguration(options));
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const { level } = opened;
  const scene = compile(level, terms);
  const budget = new WorkBudget(terms.maxWork);
  const runs = playRuns(scene, budget);
  const costs = level.runs.length > 0 ? workByEffect(scene, level.runs[0].holds, new WorkBudget(terms.maxWork)) : null;
  const played = runs.filter(({ stopped }) => stopped === null);
  const times =
    options.time === true && costs !== null && runs[0]?.stopped === null
      ? timeByEffect(scene, level.runs[0].holds, () => performance.now(), EFFECT_TIMING)
      : null;
  const inspection: Inspection = {
    file,
    level: level.name,
    terms: termsReport(scene),
    effects: {
      simulated: scene.effects.simulated.map((effect) => ({
        ...effect,
        work: costs?.find(({ name }) => name === effect.name) ?? null,
        time: times?.effects.find(({ name }) => name === effect.name)?.time ?? null,
      })),
      notCalledFor: scene.effects.notCalledFor,
    },
    counts: countObjects(level),
    modes: runs[0]?.modes ?? [],
    work: runs[0]?.work ?? NO_WORK,
    time: times?.whole.minimum ?? null,
    untimed: options.time === true && times === null ? whyUntimed(costs, runs.length > 0) : null,
    problems: withinWork(budget, () => warningsOf(opened, played, terms)) ?? warningsOf(opened, [], terms),
  };
  const output =
    options.format === 'json'
      ? inspectJson(inspection)
      : inspectPretty(inspection, colorsFor(process.stdout), widthOf(process.stdout));
  return { output, exitCode: 0 };
}

const whyUntimed = (costs: readonly EffectWork[] | null, hasRun: boolean): string => {
  if (!hasRun) return 'the level has no run';
  return costs === null ? 'arcade examines everything once a frame' : 'the run takes more work than --max-work allows';
};

const NO_WORK: Work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };

/** The results of `inspect` as JSON. */
function inspectJson({ level, terms, effects, counts, modes, work, time: whole, problems }: Inspection): string {
  const report: InspectReport = {
    version: 1,
    level,
    terms,
    effects: {
      simulated: effects.simulated.map(({ name, because, work: own, time }) => ({
        name,
        because,
        work: own && { guards: own.guards, roots: own.roots, events: own.events, ...(time !== null && { time }) },
      })),
      notCalledFor: [...effects.notCalledFor],
    },
    counts,
    modes: [...modes],
    work: { ...work, ...(whole !== null && { time: whole }) },
    problems: problems.map(problemJson),
  };
  return `${JSON.stringify(report)}\n`;
}

/** The results of `inspect` for people. */
function inspectPretty(
  { file, level, effects, counts, modes, work, time, untimed, problems }: Inspection,
  colors: Colors,
  width: number | null = null,
): string {
  const list = (rows: readonly (readonly string[])[]): string =>
    alignColumns(rows, { width: width === null ? null : width - 2 })
      .map((line) => `${line.replace(/^/gm, '  ')}\n`)
      .join('');
  const has = COUNTED.filter(({ key }) => counts[key] > 0).map(({ key, one, many }) => plural(counts[key], one, many));
  let text = `${colors.bold(visibleLine(level))}: ${has.length === 0 ? 'only the black hole' : has.join(', ')}\n`;
  text += `\n${colors.bold('simulated')}\n${list(effects.simulated.map((effect) => [effect.name, effect.because, costOf(effect, work, time)]))}`;
  if (effects.notCalledFor.length > 0)
    text += `\n${colors.bold('not called for')}\n${list(effects.notCalledFor.map(({ name, because }) => [name, because]))}`;
  if (work.pieces > 0) {
    const { pieces, forceEvaluations, guards, roots } = work;
    const counted = [
      plural(pieces, 'piece of motion', 'pieces of motion'),
      plural(forceEvaluations, 'force evaluation', 'force evaluations'),
    ];
    text += `\nthe first run takes ${[...counted, plural(guards, 'guard', 'guards'), plural(roots, 'root', 'roots')].join(', ')}\n`;
    if (time !== null) text += `on this machine it takes ${time.toFixed(2)} us per simulated second\n`;
    const spent = modes.map(({ name, share }) => `${(100 * share).toFixed(1)} % ${name}`);
    text += `time by kind of motion: ${spent.join(', ')}\n`;
  }
  if (untimed !== null) text += `\nnot timed: ${untimed}\n`;
  if (problems.length > 0) text += `\n${showFileProblems(file, problems, colors)}`;
  return text;
}

/** An effect that is simulated, and what it costs in the first run; null if that was not counted. */
interface SimulatedEffect extends ChosenEffect {
  readonly work: EffectWork | null;
  /** What it takes of the run's time, microseconds per simulated second; null if that was not measured. */
  readonly time: number | null;
}

/** What an effect costs, in words. */
function costOf({ work: own, time }: SimulatedEffect, work: Work, whole: number | null): string {
  if (own === null) return '';
  const { guards, roots, events } = own;
  const share = guards > 0 ? ` (${Math.round((100 * guards) / work.guards)} %)` : '';
  const counts = `${plural(guards, 'guard', 'guards')}${share}, ${plural(roots, 'root', 'roots')}, ${plural(events, 'event', 'events')}`;
  if (whole === null) return counts;
  return `${counts}, ${time === null ? 'not timed: the run takes too long' : `${Math.round((100 * time) / whole)} % of the time`}`;
}

/** The results of `gq inspect` for a level. */
interface Inspection {
  readonly file: string;
  /** The name of the level. */
  readonly level: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  readonly effects: { readonly simulated: readonly SimulatedEffect[]; readonly notCalledFor: readonly ChosenEffect[] };
  readonly counts: Readonly<Record<string, number>>;
  /** How the time of the first run is spent; empty without a run. */
  readonly modes: readonly Mode[];
  /** The cost of the first run. */
  readonly work: Work;
  /** What it takes, microseconds per simulated second; null if that was not measured. */
  readonly time: number | null;
  /** Why it was not timed, though that was asked for. */
  readonly untimed: string | null;
  readonly problems: readonly ShownProblem[];
}

interface Counted {
  readonly key: string;
  readonly one: string;
  readonly many: string;
  count(level: Level): number;
}

/** Makes a key of words: `hot asteroids` becomes `hotAsteroids`. */
const keyOf = (words: string): string => words.replace(/ (.)/g, (_, letter: string) => letter.toUpperCase());

function countedOf(kind: ListedKind): Counted[] {
  const { one, many, counted: [countedOne, countedMany] = [one, many], variant } = KINDS[kind];
  const list = listOf(kind);
  const countIf = (varied: boolean) => (level: Level) => {
    const objects: readonly object[] = level[list];
    return objects.filter((object) => isVariant(kind, object) === varied).length;
  };
  const plain = {
    key: variant === undefined ? list : keyOf(countedMany),
    one: countedOne,
    many: countedMany,
    count: countIf(false),
  };
  if (variant === undefined) return [plain];
  return [plain, { key: keyOf(variant.many), one: variant.one, many: variant.many, count: countIf(true) }];
}

/** What is counted in a level: the objects of each kind, with variants apart, and the runs. */
const COUNTED: readonly Counted[] = [
  ...LISTED_KINDS.flatMap(countedOf),
  { key: 'runs', one: 'run', many: 'runs', count: (level) => level.runs.length },
];

/** Counts everything in a level. */
const countObjects = (level: Level): Record<string, number> =>
  Object.fromEntries(COUNTED.map(({ key, count }) => [key, count(level)]));
