import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, InvalidArgumentError } from 'commander';
import type { GenerateReport } from '../../../schema/index.ts';
import {
  type GeneratorOptions,
  INGREDIENTS,
  type Ingredient,
  USUAL_INGREDIENTS,
  varietyOf,
  type WantedDifficulty,
  type WantedSize,
} from '../../../solver/index.ts';
import { colorsFor } from '../../colors.ts';
import type { CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions } from '../../config-file.ts';
import { Failure } from '../../failure.ts';
import type { GenerateTask, MadeLevel } from '../../generate/index.ts';
import { generatedPath, keepLevel, makeDirectory, makeLevels } from '../../generate/index.ts';
import { formatOption, jobsOption, LARGEST_SEED, seedOption, wholeNumberOption } from '../../options.ts';
import { createProgress } from '../../progress.ts';
import { readConfiguration } from '../../read-configuration.ts';
import { uncut } from '../../signals.ts';
import { visibleLine } from '../../visible.ts';
import { generateJson, generatePretty } from './report.ts';

/** The default effort for each level, ticks: takes minutes. */
const DEFAULT_EFFORT = 500_000_000;

interface Options extends ConfigOptions {
  readonly out: string;
  readonly count: number;
  readonly seed: number;
  readonly size: WantedSize;
  readonly difficulty: WantedDifficulty;
  readonly ingredients?: readonly Ingredient[];
  readonly effort: number;
  readonly jobs: number;
  readonly format: 'pretty' | 'json';
}

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(command)
    .description(
      'Make new levels from a seed, a size and a difficulty. Every level comes with runs that complete it and forgive errors.',
    )
    .requiredOption('--out <dir>', 'directory for the level files; it is created when missing')
    .option(
      '--count <n>',
      'how many levels to make, each from a seed of its own',
      wholeNumberOption('a number of levels', 1, 10_000),
      1,
    )
    .addOption(seedOption())
    .option('--size <size>', 'small, medium, large, or WIDTHxHEIGHT in px', parseSize, 'medium')
    .option('--difficulty <d>', 'easy, medium, hard, or a grade from 1 to 10', parseDifficulty, 'medium')
    .option(
      '--ingredients <list>',
      `what levels may contain besides asteroids, novae and minerals: ${INGREDIENTS.join(',')} or none (default: "${USUAL_INGREDIENTS.join(',')}")`,
      parseIngredients,
    )
    .option(
      '--effort <ticks>',
      'most ticks of 1/60 s to simulate for each level',
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
      DEFAULT_EFFORT,
    )
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('pretty', 'json'))
    .addHelpText(
      'after',
      `
A level is kept only if its run "solution" forgives as much as the difficulty requires, at the accuracies precise and arcade; if a
run "all-minerals" collects every mineral; and if drifting does not complete it and hardly any single press does. The level of a
seed is the same on every machine and for any --jobs. Levels are made from the seeds S, S + 1, ..., and a file is named after its
level and its seed. Existing files are never overwritten. Rules that gq.config.json sets are written into the files, so that the
levels stay completable. Ctrl-C ends the command; the files written so far stay.

Exit code: 0 when every level was made; 1 when a seed gave no good level; 2 when a file could not be written, or another file
has its name; 130 and 143 after SIGINT and SIGTERM.

Examples:
  $ gq generate --out drafts
  $ gq generate --out drafts --count 10 --seed 100 --difficulty hard --size large
  $ gq generate --out drafts --difficulty 4.5 --size 900x500 --ingredients hot,recoil`,
    )
    .action(async (options: Options) => finish(await generate(options)));
}

async function generate(options: Options): Promise<CommandResult> {
  const { out, count, seed, size, difficulty, ingredients, effort, jobs } = options;
  // each level has a seed of its own, with which it can be generated again
  if (seed + count - 1 > LARGEST_SEED)
    throw new Failure(`--seed ${seed} --count ${count}: expected seeds up to ${LARGEST_SEED}, found up to ${seed + count - 1}`);
  const { rules } = readConfiguration(options);
  await uncut(() => makeDirectory(out));
  const tasks = Array.from({ length: count }, (_, i): GenerateTask => {
    const options: GeneratorOptions = { seed: seed + i, size, difficulty, rules, ...(ingredients && { ingredients }) };
    return { options, effort };
  });
  const done: GenerateReport['levels'][number][] = [];
  const made: MadeLevel[] = [];
  const progress = createProgress('generated', count);
  try {
    await makeLevels(tasks, jobs, async (n, one) => {
      progress.update(n);
      made.push(one);
      // written at once, so that finished levels stay even if the command is interrupted
      await uncut(() => void done.push(keep(out, one)));
    });
  } finally {
    progress.clear();
  }
  done.sort((a, b) => a.seed - b.seed);
  made.sort((a, b) => a.seed - b.seed);
  const report: GenerateReport = {
    version: 1,
    asked: count,
    levels: done,
    rejected: done.reduce((sum, { attempts, status }) => sum + attempts - (status === 'nothing' ? 0 : 1), 0),
    reasons: reasonsOf(made),
    variety: variety(made),
  };
  const output = options.format === 'json' ? generateJson(report) : generatePretty(report, colorsFor(process.stdout));
  const taken = done.filter(({ status }) => status === 'in the way');
  const messages = taken
    .map(
      ({ file }) =>
        `error: ${visibleLine(file ?? '')}: another file with this name exists and was not overwritten; give another --out or --seed\n`,
    )
    .join('');
  const exitCode = taken.length > 0 ? 2 : done.some(({ status }) => status === 'nothing') ? 1 : 0;
  return { output, messages, exitCode };
}

/** How many layouts were thrown away for each reason, all levels together. */
function reasonsOf(made: readonly MadeLevel[]): GenerateReport['reasons'] {
  const sum: Record<string, number> = {};
  for (const { rejected } of made) for (const [reason, n] of Object.entries(rejected)) sum[reason] = (sum[reason] ?? 0) + n;
  return sum;
}

function variety(made: readonly MadeLevel[]): GenerateReport['variety'] {
  const levels = made.flatMap(({ seed, made: one }) => (one === null ? [] : [{ seed, file: one.level }]));
  const found = varietyOf(levels.map(({ file }) => file));
  if (found === null) return null;
  const { distance, first, second } = found.closest;
  return { mean: found.mean, closest: { distance, seeds: [levels[first].seed, levels[second].seed] } };
}

function keep(out: string, { seed, made, length, attempts, ticks }: MadeLevel): GenerateReport['levels'][number] {
  const cost = { seed, attempts, ticks };
  if (made === null) {
    const nothing = { file: null, name: null, grade: null, p40: null, certifiedTicks: null, length: null, presses: null };
    return { ...cost, status: 'nothing', ...nothing };
  }
  const { level, robustness, grade, holds } = made;
  const file = generatedPath(out, level.name, seed);
  return {
    ...cost,
    status: keepLevel(out, file, made),
    file,
    name: level.name,
    grade: { ...grade },
    p40: robustness.p40.p,
    certifiedTicks: robustness.certifiedTicks,
    length,
    presses: holds.length,
  };
}

const LEAST_SIDE = 360;
const GREATEST_SIDE = 4000;

function parseSize(text: string): WantedSize {
  if (text === 'small' || text === 'medium' || text === 'large') return text;
  const match = /^(\d+)x(\d+)$/.exec(text);
  const [width, height] = match === null ? [0, 0] : [Number(match[1]), Number(match[2])];
  const fits = (side: number): boolean => side >= LEAST_SIDE && side <= GREATEST_SIDE;
  if (fits(width) && fits(height)) return { width, height };
  throw new InvalidArgumentError(
    `expected small, medium, large, or WIDTHxHEIGHT with sides of ${LEAST_SIDE} to ${GREATEST_SIDE} px`,
  );
}

function parseDifficulty(text: string): WantedDifficulty {
  if (text === 'easy' || text === 'medium' || text === 'hard') return text;
  const grade = /^\d+(\.\d+)?$/.test(text) ? Number(text) : Number.NaN;
  if (grade >= 1 && grade <= 10) return grade;
  throw new InvalidArgumentError('expected easy, medium, hard, or a grade from 1 to 10');
}

function parseIngredients(text: string): readonly Ingredient[] {
  if (text === 'none') return [];
  const wanted = text.split(',').map((part) => part.trim());
  const unknown = wanted.find((part) => !INGREDIENTS.includes(part as Ingredient));
  if (unknown === undefined) return wanted as Ingredient[];
  throw new InvalidArgumentError(
    `expected none, or some of ${INGREDIENTS.join(', ')}, separated by commas; found ${JSON.stringify(unknown)}`,
  );
}
