import type { Editor, OpenLevel } from '../../context/index.ts';
import { type LostSession, watchLost } from '../../lost/index.ts';
import { type OnionSession, watchOnion } from '../../onion/index.ts';
import { type CheckWatch, watchChecks } from './check-watch.ts';
import { createDifficultySession, type DifficultySession } from './difficulty-session.ts';
import { createFixSession, type FixSession } from './fix-session.ts';
import { createOverlay, type OverlayStore } from './overlay.ts';
import { type ProofWatch, watchProofs } from './proof-watch.ts';
import { type RobustnessWatch, watchRobustness } from './robustness-watch.ts';
import { createSearchSession, type SearchSession } from './search-session.ts';
import { createSearchSettings, type SearchSettingsStore } from './search-settings.ts';

/** The searches and measurements of one level, while it is open. */
export interface SolverSession {
  readonly settings: SearchSettingsStore;
  readonly search: SearchSession;
  readonly robustness: RobustnessWatch;
  readonly difficulty: DifficultySession;
  readonly fixes: FixSession;
  readonly proofs: ProofWatch;
  readonly checks: CheckWatch;
  readonly lost: LostSession;
  /** The comparison with what was before a change. */
  readonly onion: OnionSession;
  readonly overlay: OverlayStore;
}

const sessions = new WeakMap<OpenLevel, SolverSession>();

/** The solver session of an open level, created on first use; it ends when another level is opened. */
export function solverSessionOf({ desk, session, open }: Editor, level: OpenLevel): SolverSession {
  const known = sessions.get(level);
  if (known !== undefined) return known;
  const { proof } = level;
  const settings = createSearchSettings();
  const overlay = createOverlay();
  const search = createSearchSession({ level, session, desk, settings, overlay, now: () => performance.now() });
  const robustness = watchRobustness({ level, desk });
  const proofs = watchProofs({ proof, desk });
  const checks = watchChecks({ proof, desk });
  const lost = watchLost({ level, session, desk });
  const onion = watchOnion({ level, session, desk, robustness: robustness.store });
  const difficulty = createDifficultySession({ level, desk, settings });
  const fixes = createFixSession({ level, session, desk, settings });
  const solver: SolverSession = { settings, search, robustness, difficulty, fixes, proofs, checks, lost, onion, overlay };
  sessions.set(level, solver);
  const stop = open.subscribe((current) => {
    if (current === level) return;
    stop();
    sessions.delete(level);
    search.close();
    robustness.close();
    difficulty.close();
    fixes.close();
    proofs.close();
    checks.close();
    lost.close();
    onion.close();
  });
  return solver;
}
