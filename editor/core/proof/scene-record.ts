import type { RunEnd } from '../../../check/words/index.ts';
import {
  compile,
  createSimulation,
  type Ending,
  maxTicksOf,
  playScript,
  type Run,
  type Scene,
  simulate,
  type Terms,
  TICK,
  unlimited,
  WorkBudget,
  WorkLimitReached,
} from '../../../engine/index.ts';
import { type Hold, type Level, type LevelFile, OBJECT_LISTS, RULE_NAMES } from '../../../schema/index.ts';
import { bareOf } from './answer.ts';
import { RecorderRoom, RunRecorder } from './recorder.ts';

/** ticks between two readings of the clock */
const STRIDE = 60;

/** How a run ended. @param maxTicks after which it is a timeout */
export const toEnd = (ending: Ending | null, maxTicks: number): RunEnd =>
  ending ?? { outcome: 'timeout', with: null, time: maxTicks * TICK, tick: maxTicks };

/** A run in full, and what it costs to simulate it from the start. */
interface CountedRun {
  readonly run: Run;
  /** in looks, of which a {@link WorkBudget} counts its work */
  readonly looks: number;
  /** Its cost with that of everything that was read of it since. */
  readonly all: WorkBudget;
}

/** Everything known about one scene: runs by their holds. */
export class SceneRecord {
  readonly scene: Scene;
  readonly recorder: RunRecorder;
  /** The work limit per answer. */
  readonly budget: WorkBudget;
  /** The longest a run may last, ticks. */
  readonly maxTicks: number;
  private readonly ends = new Map<string, RunEnd>();
  private readonly fulls = new Map<string, CountedRun>();

  constructor(
    readonly file: LevelFile,
    readonly level: Level,
    readonly terms: Terms,
    room: RecorderRoom,
    /** pieces of motion per answer */
    readonly work: number,
  ) {
    this.scene = compile(level, terms);
    this.maxTicks = maxTicksOf(terms);
    this.budget = new WorkBudget(work, Number.POSITIVE_INFINITY);
    this.recorder = new RunRecorder(this.scene, this.maxTicks, room, this.budget);
  }

  /** How a script ends; nothing else is recorded. @param holds sorted and disjoint @returns null if it was stopped */
  end(holds: readonly Hold[], isLate: () => boolean): RunEnd | null {
    const key = holds.join();
    const known = this.ends.get(key);
    if (known !== undefined) return known;
    const { maxTicks } = this;
    try {
      const simulation = createSimulation(this.scene, this.budget);
      while (simulation.ending === null && simulation.tick < maxTicks) {
        if (isLate()) return null;
        playScript(simulation, holds, Math.min(maxTicks, simulation.tick + STRIDE));
      }
      const end = toEnd(simulation.ending, maxTicks);
      this.ends.set(key, end);
      return end;
    } catch (error) {
      if (error instanceof WorkLimitReached) return null;
      throw error;
    }
  }

  /** A run with its events and hash, and its cost, which nothing limits. @param record whether its recording is kept */
  full(holds: readonly Hold[], record = true): CountedRun {
    const key = `${record} ${holds.join()}`;
    const known = this.fulls.get(key);
    if (known !== undefined) return known;
    const all = unlimited();
    const run = simulate(this.scene, holds, { budget: all, record });
    const counted = { run, looks: all.looks, all };
    // dragging a hold requests a new run each time
    if (this.fulls.size > 64) this.fulls.clear();
    this.fulls.set(key, counted);
    return counted;
  }
}

/** Keeps the record of the last scene while levels play alike. */
interface SceneKeeper {
  /** @param work pieces of motion per answer @returns null if even the start takes too much work */
  played(file: LevelFile, level: Level, terms: Terms, work: number): SceneRecord | null;
  /** The record for a level that is not simulated: she stands at the start. */
  still(file: LevelFile, level: Level, terms: Terms): SceneRecord;
}

/** A new scene keeper. */
export function createSceneKeeper(): SceneKeeper {
  // both records share the same arrays, as only one of them exists at a time
  const room = new RecorderRoom();
  let played: SceneRecord | null = null;
  let still: SceneRecord | null = null;
  return {
    played(file, level, terms, work) {
      if (played !== null && played.terms === terms && played.work >= work && playsAlike(played, { file, level })) {
        played.budget.looks = 0;
        return played;
      }
      still = null;
      played = null;
      try {
        played = new SceneRecord(file, level, terms, room, work);
      } catch (error) {
        if (!(error instanceof WorkLimitReached)) throw error;
      }
      return played;
    },
    still(file, level, terms) {
      if (still === null || still.terms !== terms || !playsAlike(still, { file, level })) {
        played = null;
        still = new SceneRecord(file, bareOf(level), terms, room, Number.POSITIVE_INFINITY);
      }
      return still;
    },
  };
}

/** A level and its file. */
export interface PlayedFile {
  readonly file: LevelFile;
  readonly level: Pick<Level, 'rules'>;
}

/**
 * Whether two levels have the same objects and rules, so that every run is the same in both. Objects that the files share are
 * compared by reference.
 */
export function playsAlike({ file: a, level: one }: PlayedFile, { file: b, level: other }: PlayedFile): boolean {
  if (a.range !== b.range || a.recoil !== b.recoil || a.astronaut !== b.astronaut || a.blackHole !== b.blackHole) return false;
  if (RULE_NAMES.some((name) => one.rules?.[name] !== other.rules?.[name])) return false;
  return OBJECT_LISTS.every((list) => a[list] === b[list]);
}
