import { type AccuracyName, WorkLimitReached } from '../../engine/index.ts';
import type { Level, LevelFile } from '../../schema/index.ts';
import { MarchRoom } from './march-room.ts';
import { bareOf } from './patience.ts';
import { playsAlike } from './plays-alike.ts';
import { SceneRecord } from './scene-record.ts';

/** Keeps what is known of the last scene for as long as levels play alike. */
export interface SceneKeeper {
  /** @param work pieces of motion for one answer @returns null: the level takes too much work to be begun */
  played(file: LevelFile, level: Level, accuracy: AccuracyName, work: number): SceneRecord | null;
  /** What is shown of a level that is not played: she stands at the start. */
  still(file: LevelFile, level: Level, accuracy: AccuracyName): SceneRecord;
}

/** One that has kept nothing yet. */
export function createSceneKeeper(): SceneKeeper {
  // both keep their ways in the same arrays: there is one of the two at a time
  const room = new MarchRoom();
  let played: SceneRecord | null = null;
  let still: SceneRecord | null = null;
  return {
    played(file, level, accuracy, work) {
      if (played !== null && played.accuracy === accuracy && played.work >= work && playsAlike(played, { file, level })) {
        played.budget.looks = 0;
        return played;
      }
      still = null;
      played = null;
      try {
        played = new SceneRecord(file, level, accuracy, room, work);
      } catch (error) {
        if (!(error instanceof WorkLimitReached)) throw error;
      }
      return played;
    },
    still(file, level, accuracy) {
      if (still === null || still.accuracy !== accuracy || !playsAlike(still, { file, level })) {
        played = null;
        still = new SceneRecord(file, bareOf(level), accuracy, room, Number.POSITIVE_INFINITY);
      }
      return still;
    },
  };
}
