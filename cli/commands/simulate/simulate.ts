import process from 'node:process';
import { type Command, Option } from 'commander';
import { compile } from '../../../engine/index.ts';
import type { Hold, Level, SimulateReport } from '../../../schema/index.ts';
import { chooseRun } from '../../chosen-run.ts';
import type { CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions } from '../../config-file.ts';
import { parseHolds } from '../../holds-option.ts';
import { colorsFor, Failure } from '../../io/index.ts';
import { openLevel } from '../../level-source.ts';
import { formatOption, numberOption } from '../../options.ts';
import { readConfiguration } from '../../read-configuration.ts';
import { reportRun, withinWorkOf } from '../../run-report.ts';
import { addTermsOptions, type TermsOptions, termsFrom } from '../../terms.ts';
import { simulatePretty } from './pretty.ts';

const MAX_SAMPLES = 1_000_000;

interface SimulateOptions extends ConfigOptions, TermsOptions {
  readonly run?: string;
  readonly holds?: readonly Hold[];
  readonly sample?: number;
  readonly recoil?: 'on' | 'off';
  readonly format: 'pretty' | 'json';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .description('Play one run of a level and report everything that happens.')
    .argument('<level>', 'a level file')
    .option('--run <name>', 'the run to play (default: the first)')
    .option(
      '--holds <holds>',
      'play these holds instead, in ticks of 1/60 s, [press, release): 12-96,130-188; none: she drifts',
      parseHolds,
    )
    .option('--sample <hz>', 'report her state HZ times a second', numberOption('samples a second', 0, 10_000))
    .addOption(
      new Option('--recoil <on|off>', 'turn recoil on or off for this run (default: as the level has it)').choices(['on', 'off']),
    )
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
Exit code: 0 when the run was played, however it ended; 1 when the level is invalid; 2 when it could not be played.

Examples:
  $ gq simulate levels/01-first-pull.level.json
  $ gq simulate levels/02-first-swing.level.json --run all-minerals --sample 10
  $ gq simulate levels/01-first-pull.level.json --integrator rk4 --rate 240
  $ gq simulate levels/01-first-pull.level.json --holds 12-96,130-188 --format json | jq .outcome`,
    )
    .action((file: string, options: SimulateOptions) => finish(play(file, options)));
}

function play(file: string, options: SimulateOptions): CommandResult {
  const { sample } = options;
  const terms = termsFrom(options, readConfiguration(options));
  const { maxTime } = terms;
  if (sample !== undefined && sample * maxTime > MAX_SAMPLES) {
    throw new Failure(
      `--sample ${sample} over --max-time ${maxTime} can give more than ${MAX_SAMPLES} samples: lower one of the two`,
    );
  }
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const level: Level = options.recoil === undefined ? opened.level : { ...opened.level, recoil: options.recoil === 'on' };
  const { name, holds } = chooseRun(file, level, options);
  const scene = compile(level, terms);
  const { run, report } = withinWorkOf(scene, holds, (played) => ({
    run: played,
    report: reportRun(scene, holds, played, sample ?? null),
  }));
  const output =
    options.format === 'json'
      ? `${JSON.stringify({ version: 1, ...report } satisfies SimulateReport)}\n`
      : simulatePretty(level, name, run, report, colorsFor(process.stdout));
  return { output, exitCode: 0 };
}
