import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, InvalidArgumentError, Option } from 'commander';
import { termsReport } from '../../../check/words/index.ts';
import type { Terms } from '../../../engine/index.ts';
import type { GenerateReport } from '../../../schema/index.ts';
import {
  type GeneratorOptions,
  INGREDIENTS,
  type Ingredient,
  type PackOptions,
  SYMMETRIES,
  type SymmetryKind,
  THEME_NAMES,
  type ThemeName,
  USUAL_INGREDIENTS,
  varietyOf,
  type WantedDifficulty,
  type WantedSize,
} from '../../../solver/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import {
  type GenerateTask,
  generatedPath,
  type KeptPack,
  keepLevel,
  keepPack,
  type MadeLevel,
  makeDirectory,
  makeLevels,
  makePack,
  packPath,
} from '../../generate/index.ts';
import {
  addTermsOptions,
  formatOption,
  jobsOption,
  LARGEST_SEED,
  seedOption,
  type TermsOptions,
  termsFrom,
  wholeNumberOption,
} from '../../options/index.ts';
import { colorsFor, createProgress, Failure, uncut, visibleLine } from '../../terminal/index.ts';
import { generateJson, generatePretty } from './report.ts';

/** The default effort for each level, ticks: takes minutes. */
const DEFAULT_EFFORT = 500_000_000;

interface Options extends ConfigOptions, TermsOptions {
  readonly out?: string;
  readonly pack?: string;
  readonly count: number;
  readonly seed: number;
  readonly size: WantedSize;
  readonly difficulty: WantedDifficulty;
  readonly ingredients?: readonly Ingredient[];
  readonly theme?: ThemeName | 'mixed';
  readonly symmetry?: SymmetryKind;
  readonly tempting?: boolean;
  readonly effort: number;
  readonly jobs: number;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description:
    'Make new levels from a seed, a size and a difficulty. Every level comes with runs that complete it and forgive errors.',
  more: `
A level is kept only if its run "solution" forgives as much as the difficulty requires, at the accuracies precise and arcade; if both of its runs hold under the asked terms, too; if a
run "all-minerals" collects every mineral; and if drifting does not complete it and hardly any single press does. The level of a
seed is the same on every machine and for any --jobs. Levels are made from the seeds S, S + 1, ..., and a file is named after its
level and its seed. In a pack, a level
that is too close to an earlier one gives way to one of another seed. Existing files are never overwritten. Rules that gq.config.json sets are written into the files, so that the
levels stay completable. Ctrl-C ends the command; the files written so far stay.

Exit code: 0 when every level was made; 1 when a seed gave no good level; 2 when a file could not be written, or another file
has its name; 130 and 143 after SIGINT and SIGTERM.

Examples:
  $ gq generate --out drafts
  $ gq generate --out drafts --count 10 --seed 100 --difficulty hard --size large
  $ gq generate --out drafts --difficulty 4.5 --size 900x500 --ingredients hot,recoil
  $ gq generate --out drafts --theme orbits --symmetry rotate --tempting
  $ gq generate --pack levels/orbits --count 8 --theme mixed --seed 7`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addConfigOptions(addTermsOptions(command))
    .option('--out <dir>', 'directory for the level files; it is created when missing')
    .option(
      '--pack <dir>',
      'make a pack instead: numbered files and a pack.json, grades that rise to --difficulty, no two levels alike',
    )
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
    .addOption(
      new Option('--theme <name>', 'compose each level around a theme; mixed: in a pack, one after the other').choices([
        ...THEME_NAMES,
        'mixed',
      ]),
    )
    .addOption(
      new Option('--symmetry <kind>', "symmetry of the novae of a level with a theme (default: the theme's own)").choices(
        SYMMETRIES,
      ),
    )
    .option('--tempting', 'with a theme: a mineral lies off the run "solution"; lures always has one')
    .option(
      '--effort <ticks>',
      'most ticks of 1/60 s to simulate for each level',
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
      DEFAULT_EFFORT,
    )
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('pretty', 'json'))
    .action(async (options: Options) => finish(await generate(options)));
}

async function generate(options: Options): Promise<CommandResult> {
  const { count, seed, size, difficulty, ingredients, effort, jobs, theme, symmetry, tempting, pack } = options;
  const out = pack ?? options.out;
  if (out === undefined || (pack !== undefined && options.out !== undefined))
    throw new Failure('expected either --out <dir>, for single levels, or --pack <dir>');
  if (theme === undefined && (symmetry !== undefined || tempting)) {
    const given = symmetry === undefined ? '--tempting' : `--symmetry ${symmetry}`;
    throw new Failure(
      `${given}: expected --theme as well, one of ${THEME_NAMES.join(', ')}; levels without a theme are laid out at random`,
    );
  }
  // each level has a seed of its own, with which it can be generated again
  if (seed + count - 1 > LARGEST_SEED)
    throw new Failure(`--seed ${seed} --count ${count}: expected seeds up to ${LARGEST_SEED}, found up to ${seed + count - 1}`);
  if (theme === 'mixed' && pack === undefined)
    throw new Failure(`--theme mixed: expected --pack <dir> as well; for single levels, one of ${THEME_NAMES.join(', ')}`);
  const terms = termsFrom(options, await readConfiguration(options));
  const { rules } = terms;
  await uncut(() => makeDirectory(out));
  if (pack !== undefined) {
    const rest = { ...(ingredients && { ingredients }), ...(symmetry && { symmetry }), ...(tempting && { tempting }) };
    const grades = PACK_GRADES[typeof difficulty === 'number' ? 'medium' : difficulty];
    const [first, last] = typeof difficulty === 'number' ? ([Math.min(grades[0], difficulty), difficulty] as const) : grades;
    return generatePack(
      { count, seed, size, rules, terms, theme: theme ?? 'none', grades: [first, last], ...rest },
      { out, effort, jobs },
      options.format,
    );
  }
  const tasks = Array.from({ length: count }, (_, i): GenerateTask => {
    const options: GeneratorOptions = {
      seed: seed + i,
      size,
      difficulty,
      rules,
      terms,
      ...(ingredients && { ingredients }),
      ...(theme && theme !== 'mixed' && { theme }),
      ...(symmetry && { symmetry }),
      ...(tempting && { tempting }),
    };
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
  return say(done, made, { asked: count, terms, format: options.format });
}

/** The report on levels, and the exit code. */
function say(
  done: GenerateReport['levels'],
  made: readonly MadeLevel[],
  { asked, terms, format }: { readonly asked: number; readonly terms: Terms; readonly format: Options['format'] },
  moreReasons: GenerateReport['reasons'] = {},
  pack: KeptPack | null = null,
): CommandResult {
  const alike = Object.values(moreReasons).reduce((sum, n) => sum + n, 0);
  const report: GenerateReport = {
    version: 1,
    asked,
    levels: done,
    terms: termsReport({ terms, level: terms }),
    rejected: alike + done.reduce((sum, { attempts, status }) => sum + attempts - (status === 'nothing' ? 0 : 1), 0),
    reasons: { ...reasonsOf(made), ...moreReasons },
    variety: variety(made),
    ...(pack !== null && { pack: { ...pack } }),
  };
  const output = format === 'json' ? generateJson(report) : generatePretty(report, colorsFor(process.stdout));
  const taken: { readonly file: string | null }[] = done.filter(({ status }) => status === 'in the way');
  if (pack?.status === 'in the way') taken.push(pack);
  const messages = taken
    .map(
      ({ file }) =>
        `error: ${visibleLine(file ?? '')}: another file with this name exists and was not overwritten; give another --out or --seed\n`,
    )
    .join('');
  const exitCode = taken.length > 0 ? 2 : done.some(({ status }) => status === 'nothing') ? 1 : 0;
  return { output, messages, exitCode };
}

/** The grades of the first and the last level of a pack. */
const PACK_GRADES = { easy: [1.7, 3], medium: [2, 5], hard: [3.5, 6.5] } as const;

/** Makes a pack. Levels are written in their order, each as soon as those before it are there. */
async function generatePack(
  pack: PackOptions & { readonly terms: Terms },
  { out, effort, jobs }: { readonly out: string; readonly effort: number; readonly jobs: number },
  format: Options['format'],
): Promise<CommandResult> {
  const done: GenerateReport['levels'][number][] = [];
  const progress = createProgress('generated', pack.count);
  try {
    const { made, alike } = await makePack(pack, effort, jobs, async (index, one) => {
      progress.update(done.length + 1);
      const name = one.made?.level.name ?? '';
      await uncut(() => void done.push(keep(out, one, packPath(out, name, index + 1, pack.count))));
    });
    const levels = done.flatMap(({ file, status }) => (file === null || status === 'in the way' ? [] : [file]));
    // an order of nothing would only be in the way of the next one
    const order = levels.length === 0 ? null : await uncut(() => keepPack(out, levels));
    return say(done, made, { asked: pack.count, terms: pack.terms, format }, alike > 0 ? { alike } : {}, order);
  } finally {
    progress.clear();
  }
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

function keep(out: string, { seed, made, length, attempts, ticks }: MadeLevel, path?: string): GenerateReport['levels'][number] {
  const cost = { seed, attempts, ticks };
  if (made === null) {
    const nothing = {
      ...{ file: null, name: null, grade: null, p40: null, certifiedTicks: null, length: null, presses: null },
      ...{ theme: null, symmetry: null, aside: null },
    };
    return { ...cost, status: 'nothing', ...nothing };
  }
  const { level, robustness, grade, holds, theme, symmetry, aside } = made;
  const file = path ?? generatedPath(out, level.name, seed);
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
    theme,
    symmetry,
    aside,
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
