import {
  compile,
  createSimulation,
  joinHolds,
  maxTicksOf,
  playScript,
  WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import { latticeFor, movedLevel, type Sample, Survey, shiftTo } from '../leeway/index.ts';
import type { Leeway } from '../protocol.ts';
import type { Start } from '../work.ts';

/** pieces of motion for one sample, as the page spends on a run while something is dragged */
const MOST_WORK = 50_000;

/** px between samples that agree, in the end; on a grid, every place of it is sampled */
const FINEST = 4;

/** ms between two reports */
const TELL = 200;

/** Samples where objects may stand without a run ending otherwise. */
export const leeway: Start<'leeway'> = function* ({ level, terms, holds, objects, only, lead, grid, seen }, now) {
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
  let told = now();
  let wasCovered = false;
  for (const _ of survey.work()) {
    // the first picture at once when it is complete
    const isFirst: boolean = !wasCovered && survey.isReachKnown;
    wasCovered ||= isFirst;
    const isDue = isFirst || now() - told >= TELL;
    if (isDue) told = now();
    yield isDue ? found() : null;
  }
  return found();
};
