import type { Level, ObjectList } from '../../schema/basics/index.ts';

/** Calls for an effect where the level has at least one object in `list`. */
export const whereAny =
  (list: ObjectList, one: string) =>
  (level: Level): { called: boolean; because: string } => {
    const n = level[list].length;
    return n > 0 ? { called: true, because: `${n} ${n === 1 ? one : list}` } : { called: false, because: `no ${list}` };
  };
