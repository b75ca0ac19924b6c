import process from 'node:process';
import { type Command, Option } from 'commander';
import { termsReport } from '../../../check/words/index.ts';
import { ACCURACIES } from '../../../engine/index.ts';
import { cheapestGoodEnough, METHODS, measureWorkPrecision } from '../../../engine/work-precision/index.ts';
import { drawDiagram, type Ground, levelDiagram } from '../../../picture/accuracy/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { expectOutput, levelsRead, writeWhole } from '../../io/index.ts';
import { openLevel } from '../../levels/index.ts';
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
import { type AccuracyReport, accuracyJson, accuracyPretty, brief } from './report.ts';

/** ms for the timing */
const BUDGET = 6000;

interface Options extends ConfigOptions, TermsOptions {
  readonly run?: string;
  readonly holds?: readonly Hold[];
  readonly svg?: string;
  readonly theme: Ground;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description:
    'Measure the error and the cost of every accuracy for one run of a level, and name the cheapest that is good enough.',
  more: `
Measures every named accuracy, euler, verlet and rk4 at 15 to 960 Hz, and taylor at 1e-2 to 1e-9 px, each with swept contacts
and with contacts tested once a frame. With --integrator it also measures that custom setting. Timing takes about ${BUDGET / 1000} s; a cost
is the least of several measurements.

Exit code: 0; 1 when the level is invalid; 2 when it could not be read or the diagram could not be written.

Examples:
  $ gq accuracy levels/01-first-pull.level.json
  $ gq accuracy levels/02-first-swing.level.json --run all-minerals --svg accuracy.svg
  $ gq accuracy levels/01-first-pull.level.json --integrator verlet --rate 90
  $ gq accuracy levels/01-first-pull.level.json --format json | jq '.methods[] | select(.sameVerdict | not) | .name'`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .argument('<level>', 'a level file')
    .option('--run <name>', 'the run to play (default: the first)')
    .option('--holds <holds>', 'play these holds instead, in ticks: 12-96,130-188; none: she drifts', parseHolds)
    .option('--svg <file>', 'write a work-precision diagram to FILE.svg')
    .addOption(
      new Option('--theme <theme>', 'colours of the diagram; auto follows the viewer')
        .choices(['auto', 'light', 'dark'])
        .default('auto'),
    )
    .addOption(formatOption('pretty', 'json'))
    .action(async (file: string, options: Options) => finish(await measure(file, options, command)));
}

async function measure(file: string, options: Options, command: Command): Promise<CommandResult> {
  const { svg, format } = options;
  if (svg !== undefined && !/\.svg$/i.test(svg)) throw new Failure(`--svg ${svg}: expected a name that ends in .svg`);
  refuseUnused(command, [{ option: '--theme', isUsed: svg !== undefined, needs: '--svg' }]);
  const custom = customAccuracy(options);
  const asked = custom ?? (options.accuracy === undefined ? null : ACCURACIES[options.accuracy]);
  const isNew = custom !== null && METHODS.every(({ name }) => name !== custom.name);

  const configuration = await readConfiguration(options);
  if (svg !== undefined)
    expectOutput(`--svg ${svg}`, svg, { ...levelsRead([file], 'read'), 'the configuration': configuration.file });
  const terms = termsFrom(options, configuration);
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const { level } = opened;
  const { name, holds } = chooseRun(file, level, options);
  const measured = measureWorkPrecision(level, holds, {
    maxTime: terms.maxTime,
    maxWork: terms.maxWork,
    now: () => performance.now(),
    budget: BUDGET,
    methods: isNew ? [...METHODS, custom] : METHODS,
  });
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
  if (svg !== undefined) await writeWhole(svg, draw(report, options.theme));
  return {
    output: format === 'json' ? accuracyJson(report) : accuracyPretty(report, colorsFor(process.stdout), widthOf(process.stdout)),
    messages: svg === undefined ? undefined : `wrote ${visibleLine(svg)}\n`,
    exitCode: 0,
  };
}

function draw({ level, run, measured, asked }: AccuracyReport, theme: Ground): string {
  const { outcome, time, knownTo } = measured.reference;
  const subtitle = [
    `${outcome} at ${time.toFixed(3)} s. Error: the largest distance, at ticks before the end, from a reference,`,
    knownTo === null
      ? 'which no second one confirms'
      : `which is known to ${brief(knownTo)} px: so far is a second one, of another method`,
  ];
  const named = [...Object.keys(ACCURACIES), ...(asked === null ? [] : [asked.name])];
  return drawDiagram(levelDiagram(`What accuracy costs: ${level}, ${run}`, subtitle, measured, named), theme);
}
