import process from 'node:process';
import { type Command, Option } from 'commander';
import { findCheapestSetting, type KeptRun } from '../../../check/index.ts';
import { outcomeAsPredicate, termsReport } from '../../../check/words/index.ts';
import { ACCURACIES } from '../../../engine/index.ts';
import { cheapestGoodEnough, METHODS, measureWorkPrecision } from '../../../engine/work-precision/index.ts';
import { brief, drawDiagram, type Ground, levelDiagram } from '../../../picture/accuracy/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { findConfigured, unreadableFolders } from '../../find/index.ts';
import { expectOutput, levelsRead, writeWhole } from '../../io/index.ts';
import { openLevel, orTooMuch } from '../../levels/index.ts';
import {
  addTermsOptions,
  customAccuracy,
  formatOption,
  refuseUnused,
  type TermsOptions,
  termsFrom,
} from '../../options/index.ts';
import { chooseRun, parseHolds } from '../../runs/index.ts';
import { colorsFor, Failure, visibleLine, widthOf } from '../../terminal/index.ts';
import { cheapestJson, cheapestPretty } from './cheapest-report.ts';
import { drawLens, waysAtAll } from './lens.ts';
import { type AccuracyReport, accuracyJson, accuracyPretty } from './report.ts';

/** Of a run, ms: with the references, which take up to 6 s, the whole command takes some 15 s at most. */
const BUDGET = { comparing: 4000, timing: 6000, most: 8000 };

interface Options extends ConfigOptions, TermsOptions {
  readonly run?: string;
  readonly holds?: readonly Hold[];
  readonly svg?: string;
  readonly picture?: string;
  readonly cheapest?: true;
  readonly theme: Ground;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description:
    'Measure the error and the cost of every accuracy for one run of a level, and name the cheapest that is good enough.',
  more: `
Measures every named accuracy, euler, verlet and rk4 at 15 to 960 Hz, and taylor at 1e-2 to 1e-9 px, each with swept contacts
and with contacts tested once a frame. With --integrator it also measures that custom setting. Timing takes about ${BUDGET.timing / 1000} s; a cost
is the least of several measurements. What a heavy run leaves no time for is named.

With --cheapest, settings are tried from the cheapest on, until one keeps every run of all levels: the outcome of the reference,
and the minerals and the slack of each press and release that the run has at precise.

Exit code: 0; 1 when a level is invalid, or no setting keeps all runs; 2 when it could not be read or the diagram could not be written.

Examples:
  $ gq accuracy levels/01-first-pull.level.json
  $ gq accuracy levels/02-first-swing.level.json --run all-minerals --svg accuracy.svg
  $ gq accuracy levels/01-first-pull.level.json --integrator verlet --rate 90
  $ gq accuracy levels --cheapest
  $ gq accuracy levels/01-first-pull.level.json --format json | jq '.methods[] | select(.sameVerdict | not) | .name'`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .argument('[path...]', 'a level file; with --cheapest, the same as of gq check')
    .option('--run <name>', 'the run to play (default: the first)')
    .option('--holds <holds>', 'play these holds instead, in ticks: 12-96,130-188; none: she drifts', parseHolds)
    .option('--cheapest', 'find the cheapest setting at which every run of all levels keeps outcome, minerals and slack')
    .option('--svg <file>', 'write a work-precision diagram to FILE.svg')
    .option('--picture <file>', 'write a picture of the run at all named accuracies at once to FILE.svg')
    .addOption(
      new Option('--theme <theme>', 'colours of the diagram; auto follows the viewer')
        .choices(['auto', 'light', 'dark'])
        .default('auto'),
    )
    .addOption(formatOption('pretty', 'json'))
    .action(async (paths: string[], options: Options) =>
      finish(await (options.cheapest ? findCheapest(paths, options, command) : measure(paths, options, command))),
    );
}

async function findCheapest(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  for (const option of ['run', 'holds', 'svg', 'picture'] as const)
    if (options[option] !== undefined)
      throw new Failure(`--${option} is for the report of one level: leave it or --cheapest out`);
  refuseUnused(command, [{ option: '--theme', isUsed: false, needs: '--svg' }]);
  if (customAccuracy(options) !== null || options.accuracy !== undefined)
    throw new Failure('--cheapest tries every accuracy itself: leave --accuracy, --integrator and its parts out');
  const configuration = await readConfiguration(options);
  const terms = termsFrom(options, configuration);
  const { files, unreadable } = await findConfigured(paths, configuration);
  if (unreadable.length > 0) throw unreadableFolders(unreadable);
  const opened = files.map((file) => ({ file, read: openLevel(file, terms) }));
  const failed = opened.flatMap(({ read }) => ('level' in read ? [] : [read.messages]));
  if (failed.length > 0) return { messages: failed.join(''), exitCode: 1 };
  const runs = opened.flatMap(({ file, read }) =>
    'level' in read ? read.level.runs.map(({ name, holds }): KeptRun => ({ file, name, level: read.level, holds })) : [],
  );
  if (runs.length === 0) throw new Failure('no level has a run that a setting could keep: expected at least one');
  const timing = Math.max(BUDGET.timing, 250 * runs.length);
  const budget = { timing, most: timing + 2000, all: 10_000 + 2000 * runs.length };
  const found = findCheapestSetting(runs, { terms, methods: METHODS, now: () => performance.now(), budget });
  const report = { found, terms: termsReport({ terms, level: terms }), runs: runs.length };
  return {
    output:
      options.format === 'json'
        ? cheapestJson(report)
        : cheapestPretty(report, colorsFor(process.stdout), widthOf(process.stdout)),
    exitCode: found.cheapest === null ? 1 : 0,
  };
}

async function measure([file, ...others]: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  if (file === undefined || others.length > 0)
    throw new Failure(
      `expected one level, found ${file === undefined ? 'none' : others.length + 1}: give one, or --cheapest for many`,
    );
  const { svg, picture, format } = options;
  const files = { '--svg': svg, '--picture': picture };
  for (const [option, name] of Object.entries(files))
    if (name !== undefined && !/\.svg$/i.test(name)) throw new Failure(`${option} ${name}: expected a name that ends in .svg`);
  refuseUnused(command, [{ option: '--theme', isUsed: svg !== undefined || picture !== undefined, needs: '--svg or --picture' }]);
  const custom = customAccuracy(options);
  const asked = custom ?? (options.accuracy === undefined ? null : ACCURACIES[options.accuracy]);
  const isNew = custom !== null && METHODS.every(({ name }) => name !== custom.name);

  const configuration = await readConfiguration(options);
  for (const [option, name] of Object.entries(files))
    if (name !== undefined)
      expectOutput(`${option} ${name}`, name, { ...levelsRead([file], 'read'), 'the configuration': configuration.file });
  const terms = termsFrom(options, configuration);
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const { level } = opened;
  const { name, holds } = chooseRun(file, level, options);
  const measured = orTooMuch(terms, () =>
    measureWorkPrecision(level, holds, {
      maxTime: terms.maxTime,
      maxWork: terms.maxWork,
      now: () => performance.now(),
      budget: BUDGET,
      methods: isNew ? [...METHODS, custom] : METHODS,
    }),
  );
  const report: AccuracyReport = {
    file,
    terms: termsReport({ terms, level }),
    level: level.name,
    run: name,
    holds,
    measured,
    cheapest: cheapestGoodEnough(measured.methods),
    asked,
  };
  if (svg !== undefined) await writeWhole(svg, draw(report, (asked ?? terms.accuracy).name, level.range, options.theme));
  const dark = options.theme === 'light' ? 'light' : 'dark';
  if (picture !== undefined) await writeWhole(picture, drawLens(level, name, waysAtAll(level, holds, terms), dark));
  return {
    output: format === 'json' ? accuracyJson(report) : accuracyPretty(report, colorsFor(process.stdout), widthOf(process.stdout)),
    messages: [svg, picture].flatMap((path) => (path === undefined ? [] : `wrote ${visibleLine(path)}\n`)).join(''),
    exitCode: 0,
  };
}

function draw({ level, run, measured }: AccuracyReport, used: string, range: number, theme: Ground): string {
  const { outcome, time, knownTo } = measured.reference;
  const subtitle = [
    `${outcome} at ${time.toFixed(3)} s. Error: the largest distance, at ticks before the end, from a reference,`,
    knownTo === null
      ? 'which no second one confirms'
      : `which is known to ${brief(knownTo)} px: so far is a second one, of another method`,
  ];
  const settings = measured.methods.map((method) => ({
    ...method,
    cost: method.cost.minimum,
    end: outcomeAsPredicate(method, range),
  }));
  const runs = [{ name: run, knownTo, settings }];
  const title = `What accuracy costs: ${level}, ${run}`;
  return drawDiagram(levelDiagram({ title, subtitle, runs, used, named: Object.keys(ACCURACIES) }), theme);
}
