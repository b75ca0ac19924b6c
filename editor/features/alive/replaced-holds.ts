import { joinHolds } from '../../../engine/index.ts';
import type { Hold, LevelFile } from '../../../schema/index.ts';
import type { EditedLevel, StepMark } from '../../core/document/index.ts';
import type { ProofStore } from '../../core/proof/index.ts';
import { completesNow } from './former.ts';

/** The holds that were put in place of the author's within one step, by run. */
export interface ReplacedHolds {
  /** @param start the level before the step */
  note(start: LevelFile, run: string, holds: readonly Hold[]): void;
  /**
   * Puts back the runs of the author whose new holds do not complete the level any more: a step leaves a run as it was, or
   * completes the level with it. Runs that something else has changed since are left alone.
   * @returns the names of these runs
   */
  putBack(start: LevelFile, step: StepMark): string[];
}

const runIn = ({ runs }: LevelFile, name: string) => runs?.find((run) => run.name === name);

const inShort = (holds: readonly Hold[] = []): string => joinHolds(holds).join();

export function createReplacedHolds(document: EditedLevel, proof: ProofStore): ReplacedHolds {
  let of: LevelFile | null = null;
  const replaced = new Map<string, string>();
  const follow = (start: LevelFile) => {
    if (of !== start) replaced.clear();
    of = start;
  };
  const isLost = (name: string): boolean =>
    inShort(runIn(document.file(), name)?.holds) === replaced.get(name) && !completesNow(proof.proof(), name);
  return {
    note(start, run, holds) {
      follow(start);
      replaced.set(run, inShort(holds));
    },
    putBack(start, step) {
      follow(start);
      const lost = [...replaced.keys()].filter(isLost);
      for (const name of lost) {
        replaced.delete(name);
        // with its notes, which had followed the holds
        document.amend(step, (draft) => {
          const [own, i] = [runIn(start, name), draft.runs?.findIndex((run) => run.name === name) ?? -1];
          if (own !== undefined && draft.runs !== undefined && i >= 0) draft.runs[i] = own;
        });
      }
      return lost;
    },
  };
}
