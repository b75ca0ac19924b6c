import { proveGoalImpossible, softlocksOf } from '../../../check/index.ts';
import { effortInWords, outcomeInWords, plural } from '../../../check/words/index.ts';
import { joinHolds, type Run, type Scene, simulate, TICK } from '../../../engine/index.ts';
import type { RenderOptions } from '../../../picture/index.ts';
import { type Hold, objectName } from '../../../schema/index.ts';
import {
  createRandom,
  createSearch,
  createSoftlockSurvey,
  type Goal,
  LIVES_ON,
  proofPicture,
  type Search,
  type Standing,
} from '../../../solver/index.ts';
import { withinWorkOf } from '../../levels/index.ts';
import { percent } from '../../report-parts/index.ts';
import type { ChosenRun } from '../../runs/index.ts';
import type { Solved } from '../../solve/index.ts';
import { Failure } from '../../terminal/index.ts';

/** What a picture shows, apart from its size and colours. */
export interface View extends Omit<RenderOptions, 'width' | 'theme'> {
  /** A message for people if the picture shows less than was requested. */
  readonly remark?: string;
}

/** A run to draw. @throws Failure if it costs more work than the level may */
function played(scene: Scene, holds: readonly Hold[]): Run {
  withinWorkOf(scene, holds, () => null);
  // a picture reads the whole way, which is no work on the level
  return simulate(scene, holds);
}

/** The level and one run of it. */
export function viewRun(scene: Scene, { holds }: ChosenRun): View {
  return { run: played(scene, holds), holds };
}

/** Every run of the level. */
export function viewAllRuns(scene: Scene): View {
  const { level } = scene;
  const ways = level.runs.map(({ name, holds }) => {
    const run = played(scene, holds);
    return { run, label: `${name}: ${outcomeInWords(run, level.range)}, ${plural(holds.length, 'press', 'presses')}` };
  });
  return { ways };
}

/** Really different runs that a search found. @param wanted the number that was requested */
export function viewSolved({ level }: Scene, { runs, effort }: Solved, wanted: number): View {
  const ways = runs.map(({ run, holds, robustness }) => {
    const presses = plural(holds.length, 'press', 'presses');
    return {
      run,
      label: `${run.time.toFixed(2)} s, ${presses}, succeeds in ${percent(robustness.p40.p)} of attempts with 40 ms of noise`,
    };
  });
  const tried = `simulated ${effortInWords(effort)}`;
  return {
    title: `${level.name}: ${runs.length < wanted ? `${runs.length} of ${plural(wanted, 'run')}` : plural(runs.length, 'run')} found`,
    note: `A search ${tried}.`,
    ways,
    ...(runs.length < wanted && {
      remark: `found ${runs.length} of ${wanted} clearly different runs: the search ${tried}; a larger --effort or another --seed may find more`,
    }),
  };
}

/** The number of executions in a fan. */
const FAN = 80;

/**
 * The paths of a run whose presses and releases are off by up to `ticks`: each edge alone to either side, and all of them at
 * random.
 */
export function viewFan(scene: Scene, chosen: ChosenRun, ticks: number, seed: number): View {
  const random = createRandom(seed);
  const edges = joinHolds(chosen.holds).flat();
  const play = (shifts: readonly number[]) => simulate(scene, shifted(edges, shifts));
  const alone = edges.flatMap((_, edge) => [-ticks, ticks].map((by) => edges.map((_, i) => (i === edge ? by : 0))));
  const together = Array.from({ length: FAN }, () => edges.map(() => random.below(2 * ticks + 1) - ticks));
  const fan = [...alone, ...together].map(play);
  const won = fan.filter(({ outcome }) => outcome === 'completed').length;
  const ms = (1000 * ticks * TICK).toFixed(0);
  return {
    ...viewRun(scene, chosen),
    fan,
    note:
      `${won} of ${fan.length} attempts complete it with presses and releases up to ${plural(ticks, 'tick')} (${ms} ms) too early or ` +
      'too late: each shifted alone in both directions, and all of them at random.',
  };
}

/** The holds with shifted edges. A hold that would end before it begins is dropped; ticks below 0 become 0. */
function shifted(edges: readonly number[], shifts: readonly number[]): Hold[] {
  const at = (i: number): number => Math.max(0, edges[i] + shifts[i]);
  const holds: Hold[] = [];
  for (let i = 0; i < edges.length; i += 2) if (at(i) < at(i + 1)) holds.push([at(i), at(i + 1)]);
  return [...joinHolds(holds)];
}

/** The settings of a search for pictures. */
interface Exploration {
  readonly goal: Goal;
  readonly seed: number;
  /** ticks */
  readonly effort: number;
  readonly heat: boolean;
  readonly nearest: boolean;
}

/** The places that a search has visited, its closest run, or both. */
export function viewExploration(scene: Scene, { goal, seed, effort, heat, nearest }: Exploration): View {
  const search = createSearch(scene, { goal, seed });
  search.advance(effort);
  const found = search.solutions.length;
  const runs = found === 0 ? 'it found no run' : `it found ${plural(found, 'run')}`;
  const note = `A search simulated ${effortInWords(search.effort)}; ${runs}.`;
  return {
    title: scene.level.name,
    note,
    ...(heat && { explored: search.explored }),
    ...(nearest && nearestRun(scene, search)),
  };
}

function nearestRun(scene: Scene, { solutions, closest }: Search): View {
  const [solution] = solutions;
  if (solution !== undefined) return { run: simulate(scene, solution.holds), holds: solution.holds };
  if (closest === null) return {};
  // the path is drawn up to shortly after the closest moment
  const run = simulate(scene, closest.holds, { maxTime: Math.min(scene.terms.maxTime, (closest.tick + 1) * TICK) });
  return { run, holds: closest.holds, nearest: nearestTime(closest.tick) };
}

const nearestTime = (tick: number): number => tick * TICK;

/** The proof that the goal can't be reached; null if there is none. */
export function viewProof(scene: Scene, goal: Goal): View | null {
  const { level } = scene;
  const proof = proveGoalImpossible(scene, goal);
  if (proof === null) return null;
  const what = proof.about.kind === 'blackHole' ? 'impossible' : `${objectName('mineral', proof.about.index)} is out of reach`;
  return { title: `${level.name}: ${what}`, note: `Proved: ${proof.reason}.`, proof: proofPicture(level, proof) };
}

/** Where the level is already lost although she lives on. @param effort ticks */
export function viewSoftlocks(scene: Scene, { effort, seed }: Pick<Exploration, 'effort' | 'seed'>): View {
  const survey = createSoftlockSurvey(scene, { seed });
  survey.advance(effort);
  const { states, lasting } = softlocksOf(survey);
  const marked = <T extends { readonly standing: Standing }>(list: readonly T[]) =>
    list.flatMap((one) =>
      one.standing.is === 'proved' || one.standing.is === 'not found' ? [{ ...one, known: one.standing.is }] : [],
    );
  return {
    title: `${scene.level.name}: where it is already lost`,
    note:
      `Of ${plural(states.examined, 'state')}, ${states.open} can still reach the black hole. After ${lasting.proved} that are proved ` +
      `lost, and ${lasting.notFound} from which no run was found, she lives on for a second and more.`,
    lost: { states: marked(survey.states.filter(({ alive }) => alive >= LIVES_ON)), places: marked(survey.places) },
  };
}

/** The package that draws PNGs: a native module, which not every installation has. */
const PACKAGE = '@resvg/resvg-js';

/** Draws an SVG as a PNG of a width, px; the height keeps the aspect ratio. Throws if it can't read the SVG. */
type PngRenderer = (svg: string, width: number) => Uint8Array;

/**
 * Loads what draws PNGs. It is slow to load, so only those who want a PNG call this.
 * @throws {Failure} when the package is not installed, or not for this platform
 */
export async function loadPngRenderer(load = () => import('@resvg/resvg-js')): Promise<PngRenderer> {
  const { Resvg } = await load().catch((error: unknown) => {
    const code = (error as NodeJS.ErrnoException | null)?.code;
    // the package itself is missing, or the part of it for this platform
    const isMissing = code === 'ERR_MODULE_NOT_FOUND' || code === 'MODULE_NOT_FOUND';
    const why = isMissing
      ? 'not installed'
      : `not loaded: ${String(error instanceof Error ? error.message : error).split('\n')[0]}`;
    throw new Failure(
      `a PNG needs the package ${PACKAGE}, which is ${why}
install it: npm install --save-dev ${PACKAGE}, or name a file that ends in .svg: an SVG needs no package`,
    );
  });
  // system fonts are loaded only if the built-in strokes don't suffice: that takes long, and fonts differ between machines
  return (svg, width) => {
    const font = { loadSystemFonts: svg.includes('<text ') };
    return new Resvg(svg, { font, fitTo: { mode: 'width', value: width } }).render().asPng();
  };
}
