import { availableParallelism } from 'node:os';
import process from 'node:process';
import { type Command, Option } from 'commander';
import { plural } from '../../check/words/index.ts';
import { compile, simulate, type Terms } from '../../engine/index.ts';
import { type DifficultyPicture, drawDifficulty, type Ground } from '../../picture/difficulty/index.ts';
import { renderSvg } from '../../picture/index.ts';
import { readLevel } from '../../schema/index.ts';
import type { Goal } from '../../solver/index.ts';
import type { CommandHelp, CommandResult } from '../command.ts';
import { addConfigOptions, type ConfigOptions, readConfiguration } from '../config/index.ts';
import {
  type CollectedPlays,
  causeInWords,
  collectPlays,
  curvesInWords,
  curvesOf,
  difficultyJson,
  difficultyPretty,
  type MeasuredLevel,
  type MeasureSettings,
  measureLevels,
  measureSettings,
  refusedPlays,
} from '../difficulty/index.ts';
import { findConfigured, PATHS, unreadableFolders } from '../find/index.ts';
import { reportWhole, shardOfPlan } from '../fleet/index.ts';
import { expectOutput, firstPack, levelsRead, readBytes, writeWhole } from '../io/index.ts';
import {
  addShardOptions,
  addTermsOptions,
  collect,
  formatOption,
  jobsOption,
  mineralsOption,
  refuseBesidesPlan,
  refuseUnused,
  type ShardOptions,
  seedOption,
  type TermsOptions,
  USUAL_EFFORT,
  wholeNumberOption,
} from '../options/index.ts';
import { percent } from '../report-parts/index.ts';
import { colorsFor, createProgress, createStatusLine, Failure, namedPath, visibleLine, widthOf } from '../terminal/index.ts';

interface Options extends ConfigOptions, TermsOptions, ShardOptions {
  readonly run?: string;
  readonly minerals: Goal['minerals'];
  readonly effort: number;
  readonly seed: number;
  readonly plays?: readonly string[];
  readonly picture?: string;
  readonly svg?: string;
  readonly theme: Ground;
  readonly jobs: number;
  readonly format: 'pretty' | 'json';
}

export const help: CommandHelp = {
  description: 'Measure how hard levels are: success under timing noise, slack, random play, shortcuts, and a grade.',
  more: `
The level's own runs are compared with those that a search finds, and the one that forgives most is measured. The grade is the lowest
that any of them gives. Timing noise shifts each press and release by an independent Gaussian error; people are off by 30 to 60 ms. The model simulates players who aim at
that run, miss, and learn from attempt to attempt. Neither it nor the grade is fitted to players: they compare levels, and say nothing
about people without plays of people. For a single level the report also says what collecting all minerals costs, and whether the
level can be completed without pressing, with one press, and without each asteroid that the run uses.

Where a folder has a pack.json, the report also has the grades in its order and says where they jump: a level is a jump when its
grade is 2 and more above that of the hardest level before it.

--plays simulates recorded plays again and says how often players succeed, by attempt number, too, where and why they fail, after
which press or release, and how much timing noise would explain it. It fits the model of players to their presses and releases: how
much they miss by, how fast they learn, how much they differ. A folder below a directory of plays stands for a player, whose
attempts follow each other in the order of their names; NDJSON has {"play": "<base64url>", "subject": "<player>"} a line, in order.
Plays are only read, and nothing is sent anywhere.

Exit code: 0 when every level was measured; 1 when a level is invalid or has no run to measure; 2 when a file could not be read.

Examples:
  $ gq difficulty levels                                  a table, the easiest first
  $ gq difficulty levels/16-firewalk.level.json --svg firewalk.svg
  $ gq difficulty levels/16-firewalk.level.json --run all-minerals --minerals all
  $ gq difficulty levels/16-firewalk.level.json --plays plays --picture where.svg
  $ gq difficulty levels --format json | jq '.levels[] | [.measured.grade.value, .name]'`,
};

export function declare(command: Command, finish: (result: CommandResult) => void): void {
  addShardOptions(addConfigOptions(addTermsOptions(command)))
    .argument('[path...]', PATHS)
    .option(
      '--run <name>',
      "the run to measure (default: the one that forgives most, of the level's own and those that a search finds)",
    )
    .addOption(mineralsOption())
    .option(
      '--effort <ticks>',
      'ticks of 1/60 s for the searches: half for the runs that forgive most, half for one with all minerals',
      wholeNumberOption('a number of ticks', 1, Number.MAX_SAFE_INTEGER),
      USUAL_EFFORT,
    )
    .addOption(seedOption())
    .option(
      '--plays <path>',
      'what players teach: recorded plays (.gqr), NDJSON, or directories of them, beside what the model predicts; can be given several times',
      collect,
    )
    .option('--picture <file>', 'draw the level with the places where players fail to FILE.svg; for one level, with --plays')
    .option(
      '--svg <file>',
      'write a picture of success over timing noise to FILE.svg; for one level also the slack of each press and release',
    )
    .addOption(
      new Option('--theme <theme>', 'colours of the pictures; auto follows the viewer, with --picture it is dark')
        .choices(['auto', 'light', 'dark'])
        .default('auto'),
    )
    .addOption(jobsOption(availableParallelism()))
    .addOption(formatOption('pretty', 'json'))
    .action(async (paths: string[], options: Options) => finish(await measure(paths, options, command)));
}

async function measure(paths: readonly string[], options: Options, command: Command): Promise<CommandResult> {
  refuseBesidesPlan(command, paths, options);
  if (options.plan !== undefined) return shardOfPlan('difficulty', options, options.jobs);
  const { svg, picture, theme, format, jobs } = options;
  for (const [option, file] of Object.entries({ svg, picture })) {
    if (file !== undefined && !/\.svg$/i.test(file)) throw new Failure(`--${option} ${file}: expected a name that ends in .svg`);
  }
  refuseUnused(command, [
    { option: '--theme', isUsed: svg !== undefined || picture !== undefined, needs: '--svg or --picture' },
    { option: '--picture', isUsed: options.plays !== undefined, needs: '--plays' },
  ]);
  const configuration = await readConfiguration(options);
  const asked = measureSettings(options, configuration);
  const { files, packs, unreadable } = await findConfigured(paths, configuration);
  if (picture !== undefined && files.length !== 1) {
    throw new Failure(`--picture draws one level: expected the path of one level file, found ${files.length}`);
  }
  const settings: MeasureSettings = { ...asked, inFull: files.length === 1, withCurve: svg !== undefined };
  const pack = firstPack(files);
  if (pack !== undefined) {
    refuseForPacks(pack, options);
    if (unreadable.length > 0) throw unreadableFolders(unreadable);
    return reportWhole('difficulty', asked, files, [{ name: format, file: null }], 'measured', { jobs });
  }
  const inputs = { ...levelsRead(files, 'read'), 'the configuration': configuration.file, 'a play': options.plays ?? null };
  for (const [option, file] of Object.entries({ svg, picture }))
    if (file !== undefined) expectOutput(`--${option} ${file}`, file, inputs);
  const plays = options.plays === undefined ? null : await readPlays(options.plays, files, settings, jobs);
  const progress = createProgress('measured', files.length);
  const levels = await measureLevels(files, settings, plays?.levels ?? null, jobs, progress.update);
  progress.clear();
  const lost = plays?.unreadable ?? [];
  const code = Math.max(0, ...levels.map((level) => level.code), ...[...unreadable, ...lost].map(() => 2)) as 0 | 1 | 2;
  const messages = unreadable.map(({ path, reason }) => `error: ${visibleLine(path)}: the directory can't be read: ${reason}\n`);
  for (const { path, reason } of lost) messages.push(`error: ${visibleLine(path)}: can't be read: ${reason}\n`);
  if (plays !== null && format !== 'json') messages.push(refusedPlays(plays));
  const draw = async (file: string, drawing: string | null, why: string): Promise<void> => {
    if (drawing !== null) await writeWhole(file, drawing);
    messages.push(drawing === null ? `${visibleLine(file)} was not written: ${why}\n` : `wrote ${visibleLine(file)}\n`);
  };
  if (svg !== undefined) {
    const drawing = pictureOf(levels, asked.terms.accuracy.name);
    await draw(svg, drawing && drawDifficulty(drawing, theme), 'no level was measured');
  }
  if (picture !== undefined) {
    const drawing = drawPlayers(levels[0], settings.terms, theme === 'light' ? 'light' : 'dark');
    await draw(picture, drawing, 'no play of the level counts');
  }
  const curves = curvesOf(packs, levels);
  const output =
    format === 'json'
      ? difficultyJson(levels, plays, curves)
      : difficultyPretty(levels, plays, colorsFor(process.stdout), widthOf(process.stdout)) + curvesInWords(curves);
  return { output, messages: messages.join(''), exitCode: code };
}

/** @throws Failure if an option is given that follows single files */
function refuseForPacks(pack: string, { plays, picture, svg }: Options): void {
  const given = plays !== undefined ? '--plays' : picture !== undefined ? '--picture' : svg !== undefined ? '--svg' : null;
  if (given !== null)
    throw new Failure(`${namedPath(pack)} is a pack, and ${given} is for level files: leave it out, or unpack the levels`);
}

/** Reads and simulates plays of level files. */
async function readPlays(
  paths: readonly string[],
  files: readonly string[],
  { terms, goal }: MeasureSettings,
  jobs: number,
): Promise<CollectedPlays> {
  const status = createStatusLine();
  try {
    return await collectPlays(paths, files, { terms, goal }, jobs, (done) => status.show(`simulated ${done} plays`));
  } finally {
    status.clear();
  }
}

/** With more curves than this, a picture is not readable. */
const MOST_CURVES = 12;

function pictureOf(levels: readonly MeasuredLevel[], accuracy: string): DifficultyPicture | null {
  const measured = levels.flatMap(({ name, difficulty, curve, runName }) =>
    difficulty === null ? [] : [{ name, difficulty, curve, runName }],
  );
  if (measured.length === 0) return null;
  const curves = measured.slice(0, MOST_CURVES).map(({ name, difficulty: { sigmaAtHalf }, curve }) => ({
    name,
    points: curve,
    half: sigmaAtHalf.ms <= curve[curve.length - 1].sigma ? sigmaAtHalf.ms : null,
  }));
  if (levels.length > 1) {
    const left = measured.length > MOST_CURVES ? `, the first ${MOST_CURVES} of ${measured.length}` : '';
    return {
      title: 'How hard the levels are',
      subtitle: [`${curves.length} levels${left}, ${accuracy}`],
      curves,
      edges: [],
      limit: 0,
    };
  }
  const [{ name, runName, difficulty }] = measured;
  const { grade, robustness, presses, length } = difficulty;
  const run = runName === null ? 'a run that a search found' : `run ${JSON.stringify(runName)}`;
  return {
    title: `How hard ${name} is: ${grade.word}, ${grade.value.toFixed(1)} of 10`,
    subtitle: [
      `${run}, ${accuracy}: ${length.toFixed(2)} s, ${plural(presses, 'press', 'presses')}`,
      `succeeds with all presses and releases off by up to ${plural(robustness.certifiedTicks, 'tick')}; the grade is an estimate`,
    ],
    curves,
    edges: robustness.slack.map(({ earlier, later }, i) => ({
      label: `${i % 2 === 0 ? 'press' : 'release'} ${1 + (i >> 1)}`,
      earlier,
      later,
    })),
    limit: 60,
  };
}

/** More rings than this hide the level. */
const MOST_RINGS = 6;

/**
 * Draws a level with the places where players fail, and with the run that they are compared with.
 * @returns the SVG document, or null if there is nothing to draw
 */
function drawPlayers({ file, players }: MeasuredLevel, terms: Terms, theme: 'dark' | 'light'): string | null {
  if (players === null || players.statistics.attempts === 0) return null;
  const read = readLevel(readBytes(file), terms);
  if (!read.ok) return null;
  const { all, clusters, attempts, share, low, high, reference, players: known } = players.statistics;
  const who = known === 0 ? '' : ` of ${plural(known, 'player')}`;
  return renderSvg(read.level, {
    theme,
    run: reference === null ? undefined : simulate(compile(read.level, terms), reference.holds),
    title: `Where players of ${read.level.name} fail`,
    note: `${plural(attempts, 'attempt')}${who}: ${percent(share)} succeed (${percent(low)} to ${percent(high)})`,
    failures: {
      places: all.flatMap(({ cause, x, y }) => (cause === null ? [] : { x, y })),
      clusters: clusters.slice(0, MOST_RINGS).map(({ x, y, spread, cause, count, share: part }) => ({
        ...{ x, y, spread },
        label: `${causeInWords(cause)}, ${count} (${percent(part)})`,
      })),
    },
  });
}
