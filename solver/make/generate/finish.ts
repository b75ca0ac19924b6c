import { compile, findWarnings, type Scene, simulate, WorkBudget } from '../../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../../schema/index.ts';
import { measureRobustness } from '../../measure/robustness/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import type { Attempt, Rejection, SymmetryMeasure, ThemeMeasure } from './generated.ts';
import type { GeneratorSpec, ThemeName } from './generator-spec.ts';
import { withoutIdle } from './idle.ts';
import type { Layout } from './layout.ts';
import { toLevelFile } from './level-file.ts';
import { placeMinerals } from './novae-and-minerals.ts';
import { ALL, ANY, findWays, gradeRun, sceneOf } from './scouting.ts';
import type { Stage } from './themes/index.ts';
import { flightOf, symmetryOf } from './themes/index.ts';
import { wayOf } from './tube.ts';

const MINERALS = 3;

// Ticks to find a run that collects all minerals.
const COLLECTING = 800_000;

// The least share of novae with a counterpart, where a symmetry was asked for.
const LEAST_SYMMETRY = 0.6;

// The cost of the measurements, in runs, about.
const MEASURING = 8000;

/** Removes idle objects, measures the level, places the minerals, and checks everything that is claimed. */
export function* finish(
  hardened: Layout,
  spec: GeneratorSpec,
  ways: readonly Candidate[],
  random: Random,
  description: string,
  stage: Stage,
): Attempt {
  const [solution] = ways;
  const { detour } = stage;
  const { layout, ticks } = withoutIdle(
    hardened,
    detour === null ? ways.slice(0, 3) : [...ways.slice(0, 3), detour],
    random.next(),
    stage,
  );
  yield ticks;
  const bare = sceneOf(layout);
  const precise = compile(bare.level);
  if (verifyRun(bare, solution.holds) === null || verifyRun(precise, solution.holds) === null) return 'unforgiving';
  const grade = gradeRun(precise, solution, 1);
  if (grade.value < spec.grade[0]) return 'tooEasy';
  if (grade.value > spec.grade[1]) return 'tooHard';
  const arcade = measureRobustness(bare, solution.holds, ANY, { seed: 1 });
  const robustness = measureRobustness(precise, solution.holds, ANY, { seed: 1 });
  yield MEASURING * solution.tick;
  for (const { certifiedTicks, p40 } of [robustness, arcade]) {
    if (certifiedTicks < spec.certifiedTicks || p40.p < spec.p40) return 'unforgiving';
  }

  const theme = themeMeasure(layout, spec, solution, stage);
  if (theme !== null && theme.value < theme.least) return 'offTheme';
  const symmetry = symmetryMeasure(layout, spec, stage);
  if (symmetry !== null && spec.symmetry !== null && symmetry.share < LEAST_SYMMETRY) return 'asymmetric';
  const measures = { holds: solution.holds, robustness, arcade, grade, theme, symmetry };
  if (detour !== null) {
    const level = fileOf(layout, solution, detour, spec, random, description);
    const aside = MINERALS - (verifyRun(precise, solution.holds)?.minerals.length ?? 0);
    if (aside === 0) return 'noDetour';
    const why = whyNot(level, spec);
    return why ?? { level, ...measures, aside };
  }

  // Put the minerals on several paths first, so that they have to be looked for. If no run collects them all, put them on the
  // path to the black hole.
  const several = Array.from({ length: MINERALS }, (_, i) => wayOf(bare, ways[i % ways.length].holds));
  const along = Array.from({ length: MINERALS }, () => wayOf(bare, solution.holds));
  let reason: Rejection = 'noMinerals';
  for (const mineralWays of ways.length > 1 ? [several, along, along] : [along, along]) {
    const full = placeMinerals(layout, spec, mineralWays, random);
    if (full.minerals.length < MINERALS) continue;
    const onTheWay = verifyRun(sceneOf(full), solution.holds, ALL);
    const collecting = onTheWay === null ? yield* findWays(sceneOf(full), ALL, random.next(), COLLECTING, [solution]) : [];
    const all = onTheWay ?? collecting[0];
    if (all === undefined) continue;
    const level = fileOf(full, solution, all, spec, random, description);
    const aside = MINERALS - (verifyRun(sceneOf(full), solution.holds)?.minerals.length ?? 0);
    const why = whyNot(level, spec);
    if (why === null) return { level, ...measures, aside };
    reason = why;
  }
  return reason;
}

/** The file of a finished level with its two runs. */
function fileOf(
  layout: Layout,
  solution: Candidate,
  all: Candidate,
  spec: GeneratorSpec,
  random: Random,
  description: string,
): LevelFile {
  const runs = [
    { name: 'solution', holds: solution.holds },
    { name: 'all-minerals', holds: all.holds },
  ];
  return toLevelFile(layout, nameLevel(random, spec.theme), description, runs);
}

function themeMeasure(layout: Layout, spec: GeneratorSpec, solution: Candidate, { theme, least }: Stage): ThemeMeasure | null {
  if (theme === null || spec.theme === null) return null;
  const scene = sceneOf(layout);
  const value = theme.measure(scene.level, flightOf(scene, solution.holds));
  return { name: spec.theme, measured: theme.measured, value, least };
}

function symmetryMeasure(layout: Layout, spec: GeneratorSpec, { theme, image }: Stage): SymmetryMeasure | null {
  const kind = spec.symmetry ?? theme?.symmetry ?? 'none';
  return image === null ? null : { kind, share: symmetryOf(layout, image) };
}

/**
 * Why a finished file is not good; null if it is. Both of its runs have to do what their names say at `precise`, at `arcade` and under
 * the asked terms, and no warning may be left.
 */
function whyNot(file: LevelFile, { terms }: GeneratorSpec): Rejection | null {
  const level = resolveLevel(file);
  const [solution, all] = level.runs;
  const holdsUp = (scene: Scene): boolean =>
    verifyRun(scene, []) === null && verifyRun(scene, solution.holds) !== null && verifyRun(scene, all.holds, ALL) !== null;
  if (!(['precise', 'arcade'] as const).every((accuracy) => holdsUp(compile(level, accuracy)))) return 'warnings';
  const scene = compile(level, terms);
  if (!holdsUp(scene)) return 'outOfTerms';
  const budget = new WorkBudget(terms.maxWork);
  const runs = [solution, all].map(({ holds }) => simulate(scene, holds, { budget }));
  if (runs.some(({ stopped }) => stopped !== null)) return 'outOfTerms';
  return findWarnings(level, runs, terms).length === 0 ? null : 'warnings';
}

const FIRST = [
  ...['Amber', 'Borrowed', 'Broken', 'Copper', 'Crooked', 'Distant', 'Drowsy', 'Dusty', 'Eleventh', 'Faint', 'Fallen', 'Far'],
  ...['Gentle', 'Glass', 'Hidden', 'Hollow', 'Idle', 'Indigo', 'Iron', 'Late', 'Leaning', 'Little', 'Lone', 'Long', 'Lost'],
  ...['Narrow', 'Northern', 'Old', 'Open', 'Pale', 'Patient', 'Quiet', 'Restless', 'Rusty', 'Second', 'Silver', 'Sleeping'],
  ...['Slow', 'Steady', 'Stray', 'Tidal', 'Twin', 'Velvet', 'Wandering', 'Wide', 'Winter'],
] as const;

const SECOND = [
  ...['Anchor', 'Arc', 'Beacon', 'Bend', 'Bridge', 'Cradle', 'Crossing', 'Current', 'Drift', 'Ember', 'Errand', 'Eddy'],
  ...['Ferry', 'Gap', 'Garden', 'Gate', 'Harbour', 'Hook', 'Lantern', 'Ledge', 'Loop', 'Mile', 'Needle', 'Orbit'],
  ...['Passage', 'Pendulum', 'Pier', 'Promise', 'Reach', 'Ridge', 'Round', 'Shallows', 'Shore', 'Signal', 'Spiral', 'Swing'],
  ...['Tether', 'Thread', 'Tide', 'Trail', 'Turn', 'Vault', 'Wake', 'Waltz', 'Way'],
] as const;

/** Second words that say what the level is like. */
const OF_THEME: Readonly<Record<ThemeName, readonly string[]>> = {
  orbits: ['Carousel', 'Circle', 'Crown', 'Halo', 'Moon', 'Orbit', 'Ring', 'Round', 'Satellite', 'Waltz', 'Wheel', 'Whirl'],
  corridors: [
    'Aisle',
    'Alley',
    'Avenue',
    'Canal',
    'Channel',
    'Colonnade',
    'Hallway',
    'Lane',
    'Passage',
    'Street',
    'Tunnel',
    'Walk',
  ],
  slings: ['Arrow', 'Catapult', 'Crossing', 'Dash', 'Flight', 'Gate', 'Leap', 'Shot', 'Sling', 'Throw', 'Vault', 'Voyage'],
  lures: ['Bait', 'Bargain', 'Decoy', 'Glitter', 'Jewel', 'Lure', 'Pocket', 'Purse', 'Siren', 'Temptation', 'Treasure', 'Wager'],
  fields: ['Barrage', 'Barrier', 'Breeze', 'Cushion', 'Dyke', 'Fence', 'Hedge', 'Levee', 'Shield', 'Surf', 'Wall', 'Weir'],
};

/** A random name for a level, made of two words. */
function nameLevel(random: Random, theme: ThemeName | null): string {
  const second = theme === null ? SECOND : OF_THEME[theme];
  return `${FIRST[random.below(FIRST.length)]} ${second[random.below(second.length)]}`;
}
