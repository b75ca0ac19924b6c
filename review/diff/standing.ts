import { brief, withinWork } from '../../check/index.ts';
import { maxTicksOf, type Run, type Scene, type Terms } from '../../engine/index.ts';
import { type Hold, isSame, type Level, LISTED_KINDS, listOf, type Verdict } from '../../schema/index.ts';
import { findSlackInSteps } from '../../solver/index.ts';

/** The run by which a level is judged: the first that completes it, else its first. */
export interface StandingRun extends Pick<Run, 'outcome' | 'with' | 'time' | 'tick'> {
  readonly name: string;
  readonly holds: readonly Hold[];
  /** How many different minerals it collects. */
  readonly minerals: number;
  /** The least distance to a hazard, px; null if there is none, or it was not computed. */
  readonly clearance: number | null;
  /**
   * How far each press and release can move alone, ticks; null for a run that fails, and if it was not measured. `smallestWindow`
   * is the smallest sum of both directions, null without any press.
   */
  readonly slack: {
    readonly edges: readonly (readonly [earlier: number, later: number])[];
    readonly smallestWindow: number | null;
  } | null;
}

/** What is true of a version of a level. */
export interface VersionStanding {
  readonly verdict: Exclude<Verdict, 'invalid' | 'crashed'>;
  /** The number of minerals in the level. */
  readonly mineralCount: number;
  readonly run: StandingRun | null;
}

/** How to judge a level. */
export interface AssessOptions {
  readonly terms: Terms;
  /** Whether to measure how far each press and release can move. */
  readonly slack: boolean;
}

/** The most work for measuring slack, pieces of motion: a second or two. */
const MOST_SLACK_WORK = 2_000_000;

/** Judges a level by its own runs, as a check does. The result is plain data. */
export function assessLevel(level: Level, { terms, slack }: AssessOptions): VersionStanding {
  const { scene, verdict, shown, run: played, budget } = brief(level, terms);
  if (shown === null || played === null) return { verdict, mineralCount: level.minerals.length, run: null };
  const { name, holds } = level.runs[shown];
  const { outcome, with: touched, time, tick } = played;
  const run: StandingRun = {
    ...{ name, holds, outcome, with: touched, time, tick },
    minerals: new Set(played.minerals.map(({ index }) => index)).size,
    clearance: withinWork(budget, () => played.clearance?.distance ?? null),
    slack: slack && outcome === 'completed' ? slackOf(scene, holds, played) : null,
  };
  return { verdict, mineralCount: level.minerals.length, run };
}

function slackOf(scene: Scene, holds: readonly Hold[], run: Run): StandingRun['slack'] {
  // a shifted run may go on to the time limit
  const costOfStep = Math.max(1, (run.work.pieces * maxTicksOf(scene.terms)) / Math.max(1, run.tick));
  const steps = findSlackInSteps(scene, holds, { minerals: 'any' });
  for (let cost = 0; cost <= MOST_SLACK_WORK; cost += costOfStep) {
    const step = steps.next();
    if (step.done !== true) continue;
    const edges = step.value.map(({ earlier, later }) => [earlier, later] as const);
    return { edges, smallestWindow: edges.length === 0 ? null : Math.min(...edges.map(([a, b]) => a + b)) };
  }
  return null;
}

/** Whether two versions of a level play alike: they differ at most in names, ids and texts. */
export function playAlike(before: Level, after: Level): boolean {
  const plain = (level: Level): unknown => {
    const lists = LISTED_KINDS.map((kind) => [
      listOf(kind),
      level[listOf(kind)].map((object: object) => ({ ...object, id: null })),
    ]);
    const runs = level.runs.map(({ holds }) => holds);
    return { ...level, rules: level.rules ?? null, name: '', description: '', ...Object.fromEntries(lists), runs };
  };
  return isSame(plain(before), plain(after));
}

/** The same standing for a version that plays alike. */
export const renamedStanding = (standing: VersionStanding, before: Level, after: Level): VersionStanding => {
  if (standing.run === null) return standing;
  const index = before.runs.findIndex(({ name }) => name === standing.run?.name);
  return { ...standing, run: { ...standing.run, name: after.runs[index].name } };
};
