import {
  compile,
  createSimulation,
  joinHolds,
  maxTicksOf,
  playScript,
  WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { createReporting, job, type Played, type Work } from '../job.ts';
import {
  type Lattice,
  latticeFor,
  type MovedObject,
  movedLevel,
  type Reach,
  type Sample,
  Survey,
  shiftTo,
} from '../leeway/index.ts';

/** Where objects may stand without a run ending otherwise, as far as it was sampled. */
export interface Leeway {
  /** How the run ends where they stand now; null: not known yet. */
  readonly base: Sample | null;
  readonly lattice: Lattice;
  /** Cells of the lattice: `CELL_NUMBERS` numbers each. */
  readonly cells: Int32Array;
  readonly reach: readonly Reach[];
  /** Whether all four directions were examined. */
  readonly isReachKnown: boolean;
  /** px between samples where they agree, and where they do not, at most; 0: there are none. */
  readonly every: number;
  readonly atEdges: number;
  /** Whether no part is left without samples. */
  readonly isCovered: boolean;
  readonly samples: number;
  readonly isFinished: boolean;
}

/** Where objects may stand, moved alike, without these holds ending otherwise. */
export const leeway = job<
  Played & {
    readonly holds: readonly Hold[];
    readonly objects: readonly MovedObject[];
    /** Index of the only place of each object that moves; null: all of them. */
    readonly only: number | null;
    /** The place of the first of them, which snaps to the grid, px. */
    readonly lead: { readonly x: number; readonly y: number };
    /** px between grid lines; null: objects do not snap to it. */
    readonly grid: number | null;
    /** What is examined: places of the lead, px. */
    readonly seen: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number };
  },
  Leeway,
  Leeway
>({ name: 'leeway', lane: 'long', most: null });

/** pieces of motion for one sample, as the page spends on a run while something is dragged */
const MOST_WORK = 50_000;

/** px between samples that agree, in the end; on a grid, every place of it is sampled */
const FINEST = 4;

/** ms between two reports */
const REPORT = 200;

/** Samples where objects may stand without a run ending otherwise. */
export const leewayWork: Work<typeof leeway> = {
  of: leeway,
  *steps({ level, terms, holds, objects, only, lead, grid, seen }, now) {
    const script = joinHolds(holds);
    const lattice = latticeFor(lead, grid);
    const sampleBy = (dx: number, dy: number): Sample => {
      const moved = movedLevel(level, objects, { dx, dy }, only);
      if (moved === null) return 'fails';
      try {
        const simulation = createSimulation(compile(moved, terms), new WorkBudget(MOST_WORK));
        playScript(simulation, script, maxTicksOf(terms));
        return simulation.ending?.outcome === 'completed' ? 'completes' : 'fails';
      } catch (error) {
        if (error instanceof WorkLimitReached) return 'unknown';
        throw error;
      }
    };
    const sampleAt = (i: number, j: number): Sample => {
      const { dx, dy } = shiftTo(lattice, lead, i, j);
      return sampleBy(dx, dy);
    };
    const region = {
      left: (seen.left - lattice.x) / lattice.unit,
      top: (seen.top - lattice.y) / lattice.unit,
      right: (seen.right - lattice.x) / lattice.unit,
      bottom: (seen.bottom - lattice.y) / lattice.unit,
    };
    const survey = new Survey({ sampleAt, sampleBy, region, base: lattice.base, finest: grid === null ? FINEST : lattice.base });
    const found = (): Leeway => {
      const { base, samples, isFinished, isReachKnown } = survey;
      const { uniform, mixed, isCovered } = survey.sides();
      return {
        base,
        lattice,
        cells: survey.cells(),
        reach: survey.reach(),
        isReachKnown,
        every: uniform * lattice.unit,
        atEdges: mixed * lattice.unit,
        isCovered,
        samples,
        isFinished,
      };
    };
    const isReportDue = createReporting(REPORT, now(), now);
    let wasCovered = false;
    for (const _ of survey.work()) {
      // the first picture at once when it is complete
      const isFirst: boolean = !wasCovered && survey.isReachKnown;
      wasCovered ||= isFirst;
      yield isReportDue(isFirst) ? found() : null;
    }
    return found();
  },
};
