import process from 'node:process';
import type { Command } from 'commander';
import { playRuns, withinWork } from '../../../check/index.ts';
import { termsReport } from '../../../check/words/index.ts';
import { compile, type Work, WorkBudget } from '../../../engine/index.ts';
import type { CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions } from '../../config-file.ts';
import { countObjects, type Inspection } from '../../inspection.ts';
import { colorsFor, widthOf } from '../../io/index.ts';
import { openLevel, warningsOf } from '../../level-source.ts';
import { formatOption } from '../../options.ts';
import { readConfiguration } from '../../read-configuration.ts';
import { addTermsOptions, type TermsOptions, termsFrom } from '../../terms.ts';
import { inspectJson } from './json.ts';
import { inspectPretty } from './pretty.ts';

interface InspectOptions extends ConfigOptions, TermsOptions {
  readonly format: 'pretty' | 'json';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .description('Show what a level calls for: which effects are simulated and which are not, with the reason; counts; warnings.')
    .argument('<level>', 'a level file')
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
Work and modes are those of the level's first run, as far as --max-work lets it go.

Exit code: 0; 1 when the level is invalid; 2 when it could not be read.

Examples:
  $ gq inspect levels/01-first-pull.level.json
  $ gq inspect levels/01-first-pull.level.json --format json | jq .effects.notCalledFor`,
    )
    .action((file: string, options: InspectOptions) => finish(inspect(file, options)));
}

function inspect(file: string, options: InspectOptions): CommandResult {
  const terms = termsFrom(options, readConfiguration(options));
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const { level } = opened;
  const scene = compile(level, terms);
  const budget = new WorkBudget(terms.maxWork);
  const runs = playRuns(scene, budget);
  const played = runs.filter(({ stopped }) => stopped === null);
  const inspection: Inspection = {
    file,
    level: level.name,
    terms: termsReport(scene),
    effects: scene.effects,
    counts: countObjects(level),
    modes: runs[0]?.modes ?? [],
    work: runs[0]?.work ?? NO_WORK,
    problems: withinWork(budget, () => warningsOf(opened, played, terms)) ?? warningsOf(opened, [], terms),
  };
  const output =
    options.format === 'json'
      ? inspectJson(inspection)
      : inspectPretty(inspection, colorsFor(process.stdout), widthOf(process.stdout));
  return { output, exitCode: 0 };
}

const NO_WORK: Work = { pieces: 0, forceEvaluations: 0, guards: 0, roots: 0 };
