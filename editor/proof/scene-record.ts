import type { RunEnd } from '../../check/words/index.ts';
import {
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_MAX_TICKS,
  type Ending,
  playScript,
  type Run,
  type Scene,
  simulate,
  TICK,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import type { Hold, Level, LevelFile } from '../../schema/index.ts';
import { March } from './march.ts';
import type { MarchRoom } from './march-room.ts';

/** ticks between two readings of the clock */
const STRIDE = 60;

export const toEnd = (ending: Ending | null): RunEnd =>
  ending ?? { outcome: 'timeout', with: null, time: DEFAULT_MAX_TICKS * TICK, tick: DEFAULT_MAX_TICKS };

/** Everything known about one scene: runs by their holds. */
export class SceneRecord {
  readonly scene: Scene;
  readonly march: March;
  /** The work limit per answer. */
  readonly budget: WorkBudget;
  private readonly ends = new Map<string, RunEnd>();
  private readonly fulls = new Map<string, Run>();

  constructor(
    readonly file: LevelFile,
    readonly level: Level,
    readonly accuracy: AccuracyName,
    room: MarchRoom,
    /** pieces of motion per answer */
    readonly work: number,
  ) {
    this.scene = compile(level, accuracy);
    this.budget = new WorkBudget(work, Number.POSITIVE_INFINITY);
    this.march = new March(this.scene, DEFAULT_MAX_TICKS, room, this.budget);
  }

  /** How a script ends; nothing else is recorded. @param holds sorted and disjoint @returns null if it was stopped */
  end(holds: readonly Hold[], isLate: () => boolean): RunEnd | null {
    const key = holds.join();
    const known = this.ends.get(key);
    if (known !== undefined) return known;
    try {
      const simulation = createSimulation(this.scene, this.budget);
      while (simulation.ending === null && simulation.tick < DEFAULT_MAX_TICKS) {
        if (isLate()) return null;
        playScript(simulation, holds, Math.min(DEFAULT_MAX_TICKS, simulation.tick + STRIDE));
      }
      const end = toEnd(simulation.ending);
      this.ends.set(key, end);
      return end;
    } catch (error) {
      if (error instanceof WorkLimitReached) return null;
      throw error;
    }
  }

  full(holds: readonly Hold[]): Run {
    const key = holds.join();
    const run = this.fulls.get(key) ?? simulate(this.scene, holds);
    // dragging a hold requests a new run each time
    if (this.fulls.size > 64) this.fulls.clear();
    this.fulls.set(key, run);
    return run;
  }
}
