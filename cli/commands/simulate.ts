import process from 'node:process';
import { type Command, Option } from 'commander';
import { bodyInWords, countMinerals, eventInWords, holdsInWords, outcomeInWords } from '../../check/words/index.ts';
import { compile, type Run } from '../../engine/index.ts';
import type { Hold, Level, RunReport, SimulateReport } from '../../schema/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import { openLevel, reportRun, withinWorkOf } from '../levels/index.ts';
import { addTermsOptions, formatOption, numberOption, type TermsOptions, termsFrom } from '../options/index.ts';
import { chooseRun, parseHolds } from '../runs/index.ts';
import { type Colors, colorsFor, Failure, visibleLine } from '../terminal/index.ts';

const MAX_SAMPLES = 1_000_000;

interface SimulateOptions extends ConfigOptions, TermsOptions {
  readonly run?: string;
  readonly holds?: readonly Hold[];
  readonly sample?: number;
  readonly recoil?: 'on' | 'off';
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description: 'Play one run of a level and report everything that happens.',
  more: `
Exit code: 0 when the run was played, however it ended; 1 when the level is invalid; 2 when it could not be played.

Examples:
  $ gq simulate levels/01-first-pull.level.json
  $ gq simulate levels/02-first-swing.level.json --run all-minerals --sample 10
  $ gq simulate levels/01-first-pull.level.json --integrator rk4 --rate 240
  $ gq simulate levels/01-first-pull.level.json --holds 12-96,130-188 --format json | jq .outcome`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
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
    .action(async (file: string, options: SimulateOptions) => finish(await play(file, options)));
}

async function play(file: string, options: SimulateOptions): Promise<CommandResult> {
  const { sample } = options;
  const terms = termsFrom(options, await readConfiguration(options));
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

/** One run in full for people. */
function simulatePretty(level: Level, runName: string, run: Run, report: RunReport, colors: Colors): string {
  const paint = run.outcome === 'completed' ? colors.green : colors.red;
  const { x, y, vx, vy, angle } = report.final;
  const near = run.clearance;
  const lines = [
    `${colors.bold(visibleLine(level.name))}, ${visibleLine(runName)}, ${report.accuracy}`,
    paint(outcomeInWords(run, level.range)),
    '',
    ...run.events.map((event) => `${event.time.toFixed(3).padStart(8)} s  ${eventInWords(event)}`),
    ...(run.events.length > 0 ? [''] : []),
    `holds      ${holdsInWords(report.holds)}`,
    `minerals   ${countMinerals(run)} of ${level.minerals.length}`,
    `clearance  ${near === null ? 'nothing deadly in the level' : `${near.distance.toFixed(3)} px to ${bodyInWords(near)} at ${near.time.toFixed(3)} s`}`,
    `final      x ${x.toFixed(3)}, y ${y.toFixed(3)} px; ${vx.toFixed(3)}, ${vy.toFixed(3)} px/s; angle ${angle.toFixed(4)} rad`,
    `hash       ${run.hash}`,
  ];
  if (report.samples.length > 0) {
    lines.push('', '       t s           x           y          vx          vy    angle');
    for (const [t, ...rest] of report.samples) {
      const cells = rest.map((value, i) => (i < 4 ? value.toFixed(3).padStart(12) : value.toFixed(4).padStart(9)));
      lines.push(t.toFixed(4).padStart(10) + cells.join(''));
    }
  }
  return `${lines.join('\n')}\n`;
}
