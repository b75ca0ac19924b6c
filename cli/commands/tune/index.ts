import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { accuracyInWords } from '../../../check/words/index.ts';
import { drawTuning, type Ground } from '../../../picture/tune/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { findConfigured, PATHS } from '../../find/index.ts';
import { expectOutput, levelsRead, writeWhole } from '../../io/index.ts';
import {
  addSearchOptions,
  addTermsOptions,
  formatOption,
  jobsOption,
  limitsOf,
  refuseUnused,
  type SearchOptions,
  type TermsOptions,
  termsFrom,
} from '../../options/index.ts';
import { showFileProblems } from '../../report-parts/index.ts';
import { colorsFor, createProgress, Failure, visibleLine, widthOf } from '../../terminal/index.ts';
import {
  amountsOf,
  type Change,
  parseChange,
  parseSweep,
  type Sweep,
  type TunedLevel,
  type TuneSettings,
  tuneLevels,
} from '../../tune/index.ts';
import { tuneJson, tuneText } from './report.ts';

interface Options extends ConfigOptions, TermsOptions, SearchOptions {
  readonly set?: readonly Change[];
  readonly sweep?: Sweep;
  readonly solve?: true;
  readonly svg?: string;
  readonly theme: Ground;
  readonly jobs: number;
  readonly format: 'text' | 'json';
}

export const help: CommandHelp = {
  description:
    "Show what a change of the game's rules does to each level: whether its run still completes it, and from which value on it does not.",
  more: `
The run of a level is the first that completes it. The interval after each level is where that run still completes it while one
rule changes, searched outwards from the level's value and exact to a thousandth of it; < and > mean that the run never failed on
that side. Without a sweep, values from half to twice the level's own are tried. The most fragile levels come first.

Exit code: 0 when every level was measured; 1 when a file is not a valid level; 2 for a bad option, when nothing matches, or when
a file could not be read.

Examples:
  $ gq tune levels --set pull=1.1x
  $ gq tune levels --sweep pull=0.8x..1.2x:41 --svg pull.svg
  $ gq tune levels --set push=25 --sweep boxHeight=28..36:17 --solve --effort 200000`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  const described = addConfigOptions(addTermsOptions(command))
    .argument('[path...]', PATHS)
    .option(
      '--set <rule=value>',
      "set a rule to a value, or to a multiple of each level's own like 1.1x; can be given several times",
      parseChange,
    )
    .option('--sweep <rule=from..to:count>', 'try evenly spaced values of one rule, like pull=0.8x..1.2x:41', parseSweep)
    .option('--solve', "search for a run at every value at which none of the level's own completes it");
  addSearchOptions(described, ' for each level and value')
    .option('--svg <file>', 'write a picture of the result to FILE.svg')
    .addOption(
      new Option('--theme <theme>', 'colours of the picture; auto follows the viewer')
        .choices(['auto', 'light', 'dark'])
        .default('auto'),
    )
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('text', 'json'))
    .action(async (paths: string[], options: Options) => finish(await tune(paths, options, command)));
}

async function tune(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  const { set: changes = [], sweep = null, svg } = options;
  if (changes.length === 0 && sweep === null) {
    throw new Failure('no rule is changed: give --set or --sweep, for example --set pull=1.1x');
  }
  if (sweep !== null && changes.some(({ rule }) => rule === sweep.rule)) {
    throw new Failure(`--set ${sweep.rule} and --sweep ${sweep.rule} cannot be combined: give one of the two`);
  }
  if (!options.solve && (options.budget !== undefined || options.effort !== undefined)) {
    throw new Failure('--budget and --effort limit the search of --solve: give --solve as well');
  }
  refuseUnused(command, [
    { option: '--seed', isUsed: options.solve === true, needs: '--solve' },
    { option: '--theme', isUsed: svg !== undefined, needs: '--svg' },
  ]);
  if (svg !== undefined && !/\.svg$/i.test(svg)) throw new Failure(`--svg ${svg}: expected a name that ends in .svg`);
  const configuration = await readConfiguration(options);
  const settings: TuneSettings = {
    terms: termsFrom(options, configuration),
    changes,
    sweep,
    search: options.solve ? { limits: limitsOf(options), seed: options.seed } : null,
  };
  const { files, unreadable } = await findConfigured(paths, configuration);
  if (svg !== undefined)
    expectOutput(`--svg ${svg}`, svg, { ...levelsRead(files, 'read'), 'the configuration': configuration.file });
  const progress = createProgress('tuned', files.length);
  let levels: TunedLevel[];
  try {
    levels = await tuneLevels(files, settings, options.jobs, progress.update);
  } finally {
    progress.clear();
  }
  const colors = colorsFor(process.stderr);
  const messages = [
    ...unreadable.map(({ path, reason }) => `error: ${visibleLine(path)}: the directory can't be read: ${reason}\n`),
    ...levels.filter(({ code }) => code === 2).map(({ why }) => `error: ${visibleLine(why)}\n`),
    ...levels.map(({ file, problems }) => showFileProblems(file, problems, colors)),
  ];
  if (svg !== undefined) {
    await writeWhole(svg, drawTuning(pictureOf(levels, settings), options.theme));
    messages.push(`wrote ${visibleLine(svg)}\n`);
  }
  const output =
    options.format === 'json'
      ? tuneJson(levels, settings)
      : tuneText(levels, settings, colorsFor(process.stdout), widthOf(process.stdout));
  const exitCode = Math.max(0, ...levels.map(({ code }) => code), ...unreadable.map(() => 2)) as 0 | 1 | 2;
  return { output, messages: messages.join(''), exitCode };
}

function pictureOf(levels: readonly TunedLevel[], { sweep, changes, terms }: TuneSettings) {
  const said = changes.map(({ rule, amount, isRelative }) => `${rule} ${amount}${isRelative ? 'x' : ''}`).join(', ');
  const amounts = sweep === null ? [] : amountsOf(sweep);
  return {
    title: sweep === null ? `Levels with ${said}` : `Levels while ${sweep.rule} changes`,
    subtitle: [accuracyInWords(terms), ...(sweep !== null && said !== '' ? [`with ${said}`] : []), 'the most fragile first'].join(
      ', ',
    ),
    marks: amounts.map((amount) => `${Number(amount.toPrecision(4))}${sweep?.isRelative ? 'x' : ''}`),
    rows: levels.filter(({ code }) => code === 0).map(({ name, values }) => ({ name, states: values.map(({ state }) => state) })),
  };
}
