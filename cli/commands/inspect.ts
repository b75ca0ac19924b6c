import process from 'node:process';
import type { Command } from 'commander';
import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import { colorsFor } from '../colors.ts';
import type { CommandResult } from '../command.ts';
import { countObjects, type Inspection, measureWork, type Work } from '../inspection.ts';
import { openLevel, warningsOf } from '../level-source.ts';
import { accuracyOption, formatOption, maxTimeOption } from '../options.ts';
import { inspectJson } from '../reporters/inspect-json.ts';
import { inspectPretty } from '../reporters/inspect-pretty.ts';
import { endAtOnceDuring } from '../signals.ts';

interface InspectOptions {
  readonly accuracy: string;
  readonly maxTime: number;
  readonly format: 'pretty' | 'json';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  command
    .description('What a level calls for: the effects simulated for it and those not, with the reason; counts; warnings.')
    .argument('<level>', 'a level file')
    .addOption(accuracyOption())
    .addOption(maxTimeOption())
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
The work is that of the level's first run. Exit code: 0; 1 when the level is invalid; 2 when it could not be read.

Examples:
  $ gq inspect levels/01.level.json
  $ gq inspect levels/01.level.json --format json | jq .effects.notCalledFor`,
    )
    .action((file: string, options: InspectOptions) => finish(inspect(file, options)));
}

function inspect(file: string, options: InspectOptions): CommandResult {
  return endAtOnceDuring(() => {
    const opened = openLevel(file);
    if (!('level' in opened)) return opened;
    const { level } = opened;
    const scene = compile(level, options.accuracy as AccuracyName);
    const runs = level.runs.map((script) => simulate(scene, script.holds, { maxTime: options.maxTime }));
    const inspection: Inspection = {
      file,
      level: level.name,
      effects: scene.effects,
      counts: countObjects(level),
      modes: [],
      work: runs.length === 0 ? NO_WORK : measureWork(scene, level.runs[0].holds, options.maxTime),
      problems: warningsOf(opened, runs),
    };
    const output = options.format === 'json' ? inspectJson(inspection) : inspectPretty(inspection, colorsFor(process.stdout));
    return { output, exitCode: 0 };
  });
}

const NO_WORK: Work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };
