import { availableParallelism } from 'node:os';
import { extname } from 'node:path';
import { type Command, Option } from 'commander';
import { compile, type Scene } from '../../../engine/index.ts';
import { renderSvg } from '../../../picture/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { Goal } from '../../../solver/index.ts';
import { SOFTLOCK_EFFORT } from '../../check/index.ts';
import type { CommandHelp, CommandResult } from '../../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../../config/index.ts';
import { expectOutput, levelsRead, writeWhole } from '../../io/index.ts';
import { openLevel } from '../../levels/index.ts';
import {
  addTermsOptions,
  expectMinerals,
  mineralsOption,
  refuseUnused,
  seedOption,
  type TermsOptions,
  termsFrom,
  wholeNumberOption,
} from '../../options/index.ts';
import { type ChosenRun, chooseRun, parseHolds } from '../../runs/index.ts';
import { type Solved, solveLevel } from '../../solve/index.ts';
import { Failure, namedPath, shellPath, visibleLine } from '../../terminal/index.ts';
import {
  loadPngRenderer,
  type View,
  viewAllRuns,
  viewExploration,
  viewFan,
  viewProof,
  viewRun,
  viewSoftlocks,
  viewSolved,
} from './views.ts';

const DEFAULT_WIDTH = 1200;

/** The default effort for a picture of a search, ticks. */
const DEFAULT_EFFORT = 2_000_000;

interface Options extends ConfigOptions, TermsOptions {
  readonly output: string;
  readonly run?: string | false;
  readonly holds?: readonly Hold[];
  readonly allRuns?: true;
  readonly solve?: number;
  readonly explored?: true;
  readonly closest?: true;
  readonly fan?: number;
  readonly proof?: true;
  readonly softlocks?: true;
  readonly minerals: Goal['minerals'];
  readonly effort: number;
  readonly seed: number;
  readonly width: number;
  readonly theme: 'dark' | 'light';
}

export const help: CommandHelp = {
  description: 'Draw a level with one of its runs, or with what a search or a proof shows.',
  more: `
--explored and --closest can be combined; every other view is drawn alone. --seed is for searches and for the fan.

Exit code: 0; 1 when the level is invalid, or when there is no run or no proof to draw; 2 when it could not be read or
the picture could not be written.

Examples:
  $ gq render levels/01-first-pull.level.json -o first.svg
  $ gq render levels/01-first-pull.level.json -o first.png --width 800 --theme light
  $ gq render levels/01-first-pull.level.json -o - --no-run > level.svg
  $ gq render levels/16-firewalk.level.json -o ways.svg --all-runs
  $ gq render levels/16-firewalk.level.json -o fan.svg --fan 3
  $ gq render levels/16-firewalk.level.json -o lost.svg --softlocks
  $ gq render levels/16-firewalk.level.json -o explored.png --explored --minerals all`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  const given = new Set<string>();
  addConfigOptions(addTermsOptions(command))
    .argument('<level>', 'a level file')
    .requiredOption('-o, --output <file>', 'FILE.svg or FILE.png; - writes SVG to standard output')
    .option('--run <name>', 'the run to draw (default: the first)')
    .option('--no-run', 'draw the level alone')
    .option('--holds <holds>', 'draw these holds instead, in ticks: 12-96,130-188; none: she drifts', parseHolds)
    .option('--all-runs', 'draw every run of the level, each in a colour of its own')
    .option(
      '--solve <n>',
      "search for N clearly different runs, starting from the level's own, and draw them",
      wholeNumberOption('a number of runs', 1, 20),
    )
    .option('--explored', 'draw where a search for runs has been')
    .option('--closest', 'draw the run of the closest approach of a search')
    .option(
      '--fan <ticks>',
      'draw where the run goes when its presses and releases are off by up to TICKS',
      wholeNumberOption('a number of ticks', 1, 60),
    )
    .option('--proof', 'draw why nobody can complete the level, or not with as many minerals as --minerals says')
    .option('--softlocks', "draw where the black hole can't be reached any more although she lives on")
    .addOption(mineralsOption())
    .option(
      '--effort <ticks>',
      'ticks of 1/60 s to simulate for --solve, --explored, --closest and --softlocks',
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
      DEFAULT_EFFORT,
    )
    .addOption(seedOption())
    .option('--width <px>', 'width of the picture', wholeNumberOption('a width in px', 100, 8192), DEFAULT_WIDTH)
    .addOption(new Option('--theme <theme>', 'colours').choices(['dark', 'light']).default('dark'))
    .action(async (file: string, options: Options) => {
      if (given.size > 1) throw new Failure('--run and --no-run cannot be combined: give one of the two');
      finish(await render(file, options, command));
    });
  // both set the same value: of the two, only the last is seen there
  for (const name of ['run', 'no-run']) command.on(`option:${name}`, () => given.add(name));
}

async function render(file: string, options: Options, command: Command): Promise<CommandResult> {
  const { output, width, theme } = options;
  const configuration = await readConfiguration(options);
  const terms = termsFrom(options, configuration);
  const kind = output === '-' ? '.svg' : extname(output).toLowerCase();
  if (kind !== '.svg' && kind !== '.png') {
    throw new Failure(
      `--output ${namedPath(output)}: expected a name that ends in .svg or .png, or - for SVG on standard output`,
    );
  }
  expectOneView(options);
  expectUsed(command, options);
  if (output !== '-')
    expectOutput(`-o ${output}`, output, { ...levelsRead([file], 'read'), 'the configuration': configuration.file });
  const renderPng = kind === '.png' ? await loadPngRenderer() : null;
  const opened = openLevel(file, terms);
  if (!('level' in opened)) return opened;
  const view = await viewOf(file, compile(opened.level, terms), options, command);
  if ('exitCode' in view) return view;
  const { remark, ...shown } = view;
  const said = remark === undefined ? '' : `${visibleLine(remark)}\n`;
  const svg = renderSvg(opened.level, { ...shown, width, theme });
  if (output === '-') return { output: svg, messages: said, exitCode: 0 };
  await writeWhole(output, renderPng === null ? svg : renderPng(svg, width));
  return { messages: `${said}wrote ${visibleLine(output)}\n`, exitCode: 0 };
}

/** The view that the options select, or the result of the command if there is nothing to show. */
async function viewOf(file: string, scene: Scene, options: Options, command: Command): Promise<View | CommandResult> {
  const { run: wanted, holds, minerals, effort, seed, solve } = options;
  const { level } = scene;
  const goal: Goal = { minerals };
  expectMinerals(file, level, minerals);
  if (options.proof) {
    return viewProof(scene, goal) ?? nothing(`${file}: no proof was found that nobody can do it: gq solve may find a run`);
  }
  if (options.softlocks) {
    const ticks = command.getOptionValueSource('effort') === 'default' ? SOFTLOCK_EFFORT : effort;
    return viewSoftlocks(scene, { effort: ticks, seed });
  }
  if (options.allRuns) return level.runs.length > 0 ? viewAllRuns(scene) : nothing(`${file}: the level has no run to draw`);
  if (solve !== undefined) {
    const solved = await solveFor(scene, goal, { count: solve, effort, seed });
    return solved.runs.length > 0
      ? viewSolved(scene, solved, solve)
      : nothing(`${file}: no run was found; search longer with gq solve ${shellPath(file)}`);
  }
  const explicit = wanted !== undefined || holds !== undefined;
  if (options.explored || options.closest) {
    const explored = viewExploration(scene, {
      goal,
      seed,
      effort,
      heat: options.explored === true,
      nearest: options.closest === true,
    });
    return options.explored && explicit && wanted !== false ? { ...explored, ...viewRun(scene, chosen()) } : explored;
  }
  const nothingToPlay = !explicit && level.runs.length === 0 && options.fan === undefined;
  if (wanted === false || nothingToPlay) return {};
  return options.fan === undefined ? viewRun(scene, chosen()) : viewFan(scene, chosen(), options.fan, seed);

  function chosen(): ChosenRun {
    return chooseRun(file, level, { run: wanted || undefined, holds });
  }
}

const nothing = (message: string): CommandResult => ({ messages: `error: ${visibleLine(message)}\n`, exitCode: 1 });

function solveFor(
  { level, terms }: Scene,
  goal: Goal,
  { count, effort, seed }: { readonly count: number; readonly effort: number; readonly seed: number },
): Promise<Solved> {
  const asked = { terms, goal, objective: 'robust', seed, count } as const;
  const settings = { level: { ...level, runs: [] }, ...asked, known: level.runs.map(({ holds }) => holds) };
  const limits = { budget: null, effort };
  return solveLevel(settings, { limits, jobs: availableParallelism(), onRound: () => {} });
}

/** @throws Failure if the options select views that can't be combined in one picture */
function expectOneView({ run, holds, allRuns, solve, explored, closest, fan, proof, softlocks }: Options): void {
  const views = [
    allRuns && '--all-runs',
    solve !== undefined && '--solve',
    explored ? (closest ? '--explored with --closest' : '--explored') : closest && '--closest',
    fan !== undefined && '--fan',
    proof && '--proof',
    softlocks && '--softlocks',
  ].filter((view) => typeof view === 'string');
  if (views.length > 1) throw new Failure(`${views.join(' and ')} cannot be combined: give one of them`);
  if (run === false && holds !== undefined) throw new Failure('--no-run and --holds cannot be combined: give one of the two');
  if (run === false && fan !== undefined) throw new Failure('--no-run and --fan cannot be combined: the fan shows a run');
  const withRuns = views.find((view) => view !== '--explored');
  if (run === false && withRuns !== undefined) {
    throw new Failure(`--no-run and ${withRuns} cannot be combined: ${withRuns} shows what a run does`);
  }
  const others = views.filter((view) => view !== '--fan' && view !== '--explored');
  const given = typeof run === 'string' ? '--run' : holds !== undefined ? '--holds' : null;
  if (given !== null && others.length > 0) throw new Failure(`${given} and ${others[0]} cannot be combined: give one of the two`);
}

/** @throws Failure if an option was given that has no effect on the view */
function expectUsed(command: Command, { solve, explored, closest, fan, proof, softlocks }: Options): void {
  const searches = solve !== undefined || explored === true || closest === true;
  const needs = '--solve, --explored, --closest or --softlocks';
  refuseUnused(command, [
    { option: '--effort', isUsed: searches || softlocks === true, needs },
    {
      option: '--seed',
      isUsed: searches || softlocks === true || fan !== undefined,
      needs: '--solve, --explored, --closest, --softlocks or --fan',
    },
    { option: '--minerals', isUsed: searches || proof === true, needs: '--solve, --explored, --closest or --proof' },
  ]);
}
