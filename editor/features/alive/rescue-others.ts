import { joinHolds } from '../../../engine/index.ts';
import type { LevelFile } from '../../../schema/index.ts';
import { type EditedLevel, replaceHolds, type StepMark } from '../../core/document/index.ts';
import type { ProofStore } from '../../core/proof/index.ts';
import type { Surviving } from './alive-state.ts';
import { completesNow, othersOf } from './former.ts';
import type { ReplacedHolds } from './replaced-holds.ts';
import { replayed } from './replayed.ts';
import type { HoldSeeker } from './seek-holds.ts';

/** Ticks that are simulated for each run. */
const EFFORT = 1_000_000;

/** So many runs are kept alive at most. */
const MOST = 4;

interface RescueParts {
  readonly document: EditedLevel;
  readonly proof: ProofStore;
  readonly seeker: HoldSeeker;
  readonly replaced: ReplacedHolds;
}

/**
 * Keeps runs besides the shown one alive that a step has broken, one after the other, and extends the step.
 * @param start the level before the step
 * @param shown the name of the shown run; null if it did not complete the level before
 * @param hear called at the end, unless something else was done since; null: no other run was broken
 */
export function rescueOthers(
  { document, proof, seeker, replaced }: RescueParts,
  { start, shown, step }: { readonly start: LevelFile; readonly shown: string | null; readonly step: StepMark },
  hear: (surviving: Surviving | null) => void,
): void {
  const all = othersOf(start, shown, proof.proof());
  const broken = all.filter(({ name }) => !completesNow(proof.proof(), name));
  const names = [...all.map(({ name }) => name), ...(shown === null ? [] : [shown])];
  const next = (i: number) => {
    const former = broken[i];
    if (former === undefined || i === MOST) {
      const complete = names.filter((name) => completesNow(proof.proof(), name)).length;
      hear(broken.length === 0 ? null : { complete, of: names.length });
      return;
    }
    seeker.ask({ former, warm: null, effort: EFFORT, certifies: false }, ({ best, isLast }) => {
      if (!isLast || document.lastStep() !== step) return;
      const holds = best?.holds ?? null;
      if (holds !== null && replayed(proof.proof().scene, joinHolds(holds)) !== null) {
        const { ok } = document.amend(step, replaceHolds(former.name, holds));
        if (ok) replaced.note(start, former.name, holds);
      }
      next(i + 1);
    });
  };
  next(0);
}
