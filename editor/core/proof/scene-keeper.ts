import { type Terms, WorkLimitReached } from '../../../engine/index.ts';
import type { Level, LevelFile } from '../../../schema/index.ts';
import { MarchRoom } from './march-room.ts';
import { bareOf } from './patience.ts';
import { playsAlike } from './plays-alike.ts';
import { SceneRecord } from './scene-record.ts';

/** Keeps the record of the last scene while levels play alike. */
export interface SceneKeeper {
  /** @param work pieces of motion per answer @returns null if even the start takes too much work */
  played(file: LevelFile, level: Level, terms: Terms, work: number): SceneRecord | null;
  /** The record for a level that is not simulated: she stands at the start. */
  still(file: LevelFile, level: Level, terms: Terms): SceneRecord;
}

/** A new scene keeper. */
export function createSceneKeeper(): SceneKeeper {
  // both records share the same arrays, as only one of them exists at a time
  const room = new MarchRoom();
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
