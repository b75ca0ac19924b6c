import { createPackJudge, type PackOptions, packLevel } from '../../solver/index.ts';
import type { MadeLevel } from './make-level.ts';
import { makeLevels } from './make-levels.ts';

/** What became of a pack. */
export interface PackResult {
  /** For each level, in order, what was made last, accepted or not. */
  readonly made: readonly MadeLevel[];
  /** How many levels were rejected because they were too close to an earlier one. */
  readonly alike: number;
}

// How often a level of the pack is tried with another seed.
const ROUNDS = 4;

/**
 * Makes the levels of a pack in worker threads. They are judged in their order, so the pack is the same for any number of threads.
 * A level that is rejected, or for which nothing good was found, is tried with another seed after the others.
 * @param effort most ticks for each try
 * @param jobs the largest number of threads
 * @param onAccepted called with each level once it is accepted, and at the end with those for which nothing was found
 */
export async function makePack(
  pack: PackOptions,
  effort: number,
  jobs: number,
  onAccepted: (index: number, made: MadeLevel) => Promise<void>,
): Promise<PackResult> {
  const judge = createPackJudge();
  const last = new Map<number, MadeLevel>();
  let alike = 0;
  let pending = Array.from({ length: pack.count }, (_, i) => i);
  for (let round = 0; round < ROUNDS && pending.length > 0; round++) {
    const tasks = pending.map((index) => ({ options: packLevel(pack, index, round), effort }));
    const waiting = new Map<number, MadeLevel>();
    const rejected: number[] = [];
    let next = 0;
    const judgeReady = async () => {
      for (; next < tasks.length; next++) {
        const ready = waiting.get(tasks[next].options.seed);
        if (ready === undefined) return;
        const index = pending[next];
        const all = added(ready, last.get(index));
        last.set(index, all);
        const isGood = ready.made !== null && judge.accepts(ready.made.level);
        if (isGood) await onAccepted(index, all);
        else rejected.push(index);
        if (!isGood && ready.made !== null) alike++;
      }
    };
    // one after the other, since levels become ready while others are judged
    let judging = Promise.resolve();
    await makeLevels(tasks, jobs, (_, one) => {
      waiting.set(one.seed, one);
      judging = judging.then(judgeReady);
      return judging;
    });
    pending = rejected;
  }
  for (const index of pending) {
    const nothing = last.get(index);
    if (nothing === undefined) continue;
    last.set(index, { ...nothing, made: null, length: null });
    await onAccepted(index, { ...nothing, made: null, length: null });
  }
  return { made: [...last.entries()].sort(([a], [b]) => a - b).map(([, one]) => one), alike };
}

/** A try with the effort of the one before it. */
const added = (now: MadeLevel, before: MadeLevel | undefined): MadeLevel =>
  before === undefined ? now : { ...now, attempts: now.attempts + before.attempts, ticks: now.ticks + before.ticks };
