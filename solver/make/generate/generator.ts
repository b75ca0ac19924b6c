import type { Scene } from '../../../engine/index.ts';
import { successProbability } from '../../measure/robustness/index.ts';
import { createRandom, type Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import { compose } from './compose.ts';
import { finish } from './finish.ts';
import { type Attempt, type Generated, REJECTIONS, type Rejection } from './generated.ts';
import { type GeneratorOptions, type GeneratorSpec, specOf } from './generator-spec.ts';
import { closeShortcuts, harden, withoutUnused } from './harden.ts';
import { type Layout, layOut } from './layout.ts';
import { addNovae } from './novae-and-minerals.ts';
import { findRoute, type Route } from './route.ts';
import { ANY, findWays, gradeRun, sceneOf, scoutOnePress, sortByP40 } from './scouting.ts';
import { isOnTheme, PLAIN_STAGE, Site, type Stage, THEMES, type Theme, withImages } from './themes/index.ts';
import { forgives, tubeOf } from './tube.ts';

/** Generates one level. The caller decides how long it works. */
export interface LevelGenerator {
  /** The work done so far. */
  readonly effort: {
    /** Layouts begun. */
    readonly attempts: number;
    /** Ticks simulated, plus 1000 for each attempt. */
    readonly ticks: number;
    /** How many were given up for each reason. */
    readonly rejected: Readonly<Record<Rejection, number>>;
  };
  /** The level; null until one fulfils everything that was asked for. */
  readonly result: Generated | null;
  /**
   * Continues the work until there is a result or the ticks are spent. The same seed gives the same level however the work is
   * split into calls.
   * @param ticks how many more ticks to simulate; the generator may overshoot
   */
  advance(ticks: number): void;
}

// The cost of an attempt besides its simulations, ticks, so that attempts that fail at once also come to an end.
const OVERHEAD = 1000;

/**
 * Creates a generator that makes a level from a seed. It lays out asteroids at random, finds a run, closes easier paths with
 * novae until the level is as hard as wanted, and adds minerals. Layouts that fail are discarded, and the next one is begun.
 * @param options the seed, and what the level should be like
 * @returns a generator at its start
 * @throws RangeError if the size or the difficulty is out of range
 * @example
 * ```ts
 * import { createGenerator } from 'gravity-quest-toolkit/solver';
 *
 * const generator = createGenerator({ seed: 7, size: 'small', difficulty: 'easy' });
 * while (generator.result === null) generator.advance(1_000_000);
 * console.log(generator.result.level.name, generator.result.grade.value);
 * ```
 */
export function createGenerator(options: GeneratorOptions): LevelGenerator {
  const asked = specOf(options);
  const spec = asked.theme === null ? asked : { ...asked, ...THEMES[asked.theme].adjust(asked) };
  const random = createRandom(options.seed);
  const description = `Generated from seed ${options.seed}.`;
  let attempts = 0;
  let ticks = 0;
  const rejected = Object.fromEntries(REJECTIONS.map((reason) => [reason, 0])) as Record<Rejection, number>;
  let result: Generated | null = null;
  let attempt: Attempt | null = null;
  return {
    get effort() {
      return { attempts, ticks, rejected: { ...rejected } };
    },
    get result() {
      return result;
    },
    advance(more) {
      const until = ticks + more;
      while (result === null && ticks < until) {
        if (attempt === null) {
          attempts++;
          ticks += OVERHEAD;
          attempt = attemptLevel(random.fork(), spec, description);
        }
        const step = attempt.next();
        if (step.done !== true) {
          ticks += step.value;
          continue;
        }
        if (typeof step.value === 'string') rejected[step.value]++;
        else result = step.value;
        attempt = null;
      }
    },
  };
}

// How often a level is changed towards the wanted grade.
const ROUNDS = 12;

// Ticks to find easier runs after each change.
const EASIER_EFFORT = 300_000;

// Known runs that are kept from round to round.
const WAYS = 6;

// The costs of grading a run, and of measuring one to sort it, in runs, about.
const GRADING = 1000;
const SORTING = 200;

// The attempt is given up when the grade has not risen by so much in so many rounds.
const RISE = 0.1;
const PATIENCE = 3;

const SAMPLES = 150;

// How far success of the kept run stays above the least that is promised, since it is measured again in the end.
const RESERVE = 0.04;

// The least radius of the black hole, px, and by how much it shrinks at a time.
const SMALLEST = 12;
const SHRINK = 2;

/**
 * Makes one attempt at a level that fulfils a spec. A run comes first and the level is built around it:
 *
 * 1. Lay out asteroids at random, and find a run through them that ends where the black hole is then placed ({@link
 *    findRoute}). A theme lays out its own asteroids and fields, and says which runs suit it.
 * 2. Add novae outside a tube around the run, which holds the run's slightly mistimed variations as well; a theme composes them
 *    ({@link compose}).
 * 3. Find other runs; the best of all says how hard the level is. While it is too easy, keep the run whose own grade is closest to
 *    what is wanted, and close what is easier ({@link harden}). Where nothing can be closed, the black hole shrinks. A theme
 *    says where novae may go, and the best run has to be of the theme.
 * 4. Remove idle objects, add minerals, measure the finished level and check everything that is claimed of it ({@link finish}).
 *
 * A level that fails any of the promises is discarded.
 */
function* attemptLevel(random: Random, spec: GeneratorSpec, description: string): Attempt {
  const theme = spec.theme === null ? null : THEMES[spec.theme];
  const empty = theme === null ? layOut(random, spec) : arrange(random, spec, theme);
  if (empty === null) return 'noRoom';
  const route = yield* findRoute(empty, spec, random, theme);
  if (route === null) return 'noRun';
  const surrounded = theme === null ? withNovae(route, spec, random) : yield* compose(route, spec, theme, random);
  if (typeof surrounded === 'string') return surrounded;
  const { stage } = surrounded;
  let { layout } = surrounded;

  const { run } = route;
  let known: readonly Candidate[] = [run];
  let reason: Rejection = 'tooEasy';
  let [highest, risen] = [0, 0];
  for (let round = 0; round < ROUNDS; round++) {
    const scene = sceneOf(layout);
    const still = known.filter(({ holds }) => verifyRun(scene, holds) !== null);
    const found = yield* findWays(scene, ANY, random.next(), EASIER_EFFORT);
    const all = sortByP40(scene, different([...still, ...found]));
    yield SORTING * all.reduce((sum, { tick }) => sum + tick, 0);
    const intended = all.find(({ holds }) => holds.join(' ') === run.holds.join(' '));
    if (intended === undefined) return 'noRun';
    known = [...new Set([...all.slice(0, WAYS), intended])];
    const [best] = all;
    const grade = gradeRun(scene, best, 1).value;
    yield GRADING * best.tick;
    if (grade > spec.grade[1]) return 'tooHard';
    if (grade >= highest + RISE) [highest, risen] = [grade, round];
    const presses = scoutOnePress(scene, best);
    yield presses.ticks;
    const isHardEnough = grade >= spec.grade[0] && isOnTheme(stage, layout, best);
    if (isHardEnough && presses.count <= spec.onePress * presses.tried) {
      const generated = yield* finish(layout, spec, known, random, description, stage);
      if (typeof generated !== 'string') return generated;
      reason = generated;
      if (reason !== 'tooEasy') return reason;
    }
    if (round - risen >= PATIENCE) return reason;
    if (!isForgiving(scene, intended, spec, random)) return 'unforgiving';
    const tube = [...tubeOf(scene, run.holds, spec.certifiedTicks, random), ...stage.detourWays];
    const closed = closeShortcuts(layout, spec, tube, best, random, stage.slots);
    const harder = closed === layout ? harden(layout, spec, intended, known, random, stage) : closed;
    const next = harder === layout ? shrunk(layout) : harder;
    if (next === null) return reason;
    layout = stage.image === null ? next : withImages(new Site(spec, random, next, tube), stage.image);
  }
  return reason;
}

/** The start, asteroids and fields of a theme; null when they do not fit. */
function arrange(random: Random, spec: GeneratorSpec, theme: Theme): Layout | null {
  const site = new Site(spec, random);
  return theme.arrange(site) ? site.layout : null;
}

/** A level without a theme: novae around its route. */
function withNovae(route: Route, spec: GeneratorSpec, random: Random): { layout: Layout; stage: Stage } {
  const { run } = route;
  const layout = withoutUnused(route.layout, run.holds);
  const tube = tubeOf(sceneOf(layout), run.holds, spec.tube, random);
  return { layout: addNovae(layout, spec, tube, spec.novae, random), stage: PLAIN_STAGE };
}

/** Whether a run may be narrowed: success is measured again in the end. */
const isForgiving = (scene: Scene, { holds }: Candidate, spec: GeneratorSpec, random: Random): boolean =>
  successProbability(scene, holds, ANY, 40, { samples: SAMPLES, seed: 1 }).p >= spec.p40 + RESERVE &&
  forgives(scene, holds, spec.certifiedTicks, random);

/** The layout with a smaller black hole; null when it is small already. */
function shrunk(layout: Layout): Layout | null {
  const radius = layout.blackHole.radius - SHRINK;
  return radius < SMALLEST ? null : { ...layout, blackHole: { ...layout.blackHole, radius } };
}

/** Runs without those that are the same. */
function different(runs: readonly Candidate[]): Candidate[] {
  return [...new Map(runs.map((run) => [run.holds.join(' '), run])).values()];
}
