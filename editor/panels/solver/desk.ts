import type { Editor, OpenLevel } from '../../context/index.ts';
import { pageTimers } from '../../files/index.ts';
import { afterRest } from '../parts/index.ts';
import { type CheckWatch, watchChecks } from './check-watch.ts';
import { createDifficultyDesk, type DifficultyDesk } from './difficulty.ts';
import { createOverlay, type OverlayStore } from './overlay.ts';
import { type ProofWatch, watchProofs } from './proof-watch.ts';
import { type RobustnessWatch, watchRobustness } from './robustness-watch.ts';
import { createSearchDesk, type SearchDesk } from './search.ts';
import { createWish, type WishStore } from './wish.ts';

/** All that is looked for and measured in one level, while it is open. */
export interface SolverDesk {
  readonly wish: WishStore;
  readonly search: SearchDesk;
  readonly robustness: RobustnessWatch;
  readonly difficulty: DifficultyDesk;
  readonly proofs: ProofWatch;
  readonly checks: CheckWatch;
  readonly overlay: OverlayStore;
}

const desks = new WeakMap<OpenLevel, SolverDesk>();

/** The desk of an open level, set up when it is first asked for; it is cleared when another level is opened. */
export function solverDeskOf({ workers, session, open }: Editor, level: OpenLevel): SolverDesk {
  const known = desks.get(level);
  if (known !== undefined) return known;
  const wish = createWish();
  const overlay = createOverlay();
  const search = createSearchDesk({ level, session, workers, wish, overlay, now: () => performance.now() });
  const robustness = watchRobustness({ level, workers, after: pageTimers.after, afterRest });
  const proofs = watchProofs({ level, workers, afterRest });
  const checks = watchChecks({ level, workers, afterRest });
  const difficulty = createDifficultyDesk({ level, workers, wish });
  const desk: SolverDesk = { wish, search, robustness, difficulty, proofs, checks, overlay };
  desks.set(level, desk);
  const stop = open.subscribe((current) => {
    if (current === level) return;
    stop();
    desks.delete(level);
    search.close();
    robustness.close();
    difficulty.close();
    proofs.close();
    checks.close();
  });
  return desk;
}
