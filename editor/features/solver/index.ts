import { ofLevel, useEditor, useLevel } from '../../core/context/index.ts';
import { createDifficultySession, type DifficultySession } from './difficulty-session.ts';
import { createFixSession, type FixSession } from './fix-session.ts';
import { type RobustnessWatch, watchRobustness } from './robustness-watch.ts';
import { createOverlay, createSearchSession, type OverlayStore, type SearchSession } from './search-session.ts';
import { createSearchSettings, type SearchSettingsStore } from './search-task.ts';

/** The searches and measurements of one level, while it is open. */
interface SolverSession {
  readonly settings: SearchSettingsStore;
  readonly search: SearchSession;
  readonly robustness: RobustnessWatch;
  readonly difficulty: DifficultySession;
  readonly fixes: FixSession;
  readonly overlay: OverlayStore;
  close(): void;
}

/** The searches and measurements of an open level. */
export const solverSessionOf = ofLevel<SolverSession>(({ desk, session }, level) => {
  const settings = createSearchSettings();
  const overlay = createOverlay();
  const search = createSearchSession({ level, session, desk, settings, overlay, now: () => performance.now() });
  const robustness = watchRobustness({ level, desk });
  const difficulty = createDifficultySession({ level, desk, settings });
  const fixes = createFixSession({ level, session, desk, settings });
  return {
    ...{ settings, search, robustness, difficulty, fixes, overlay },
    close() {
      search.close();
      robustness.close();
      difficulty.close();
      fixes.close();
    },
  };
});

/** The solver session of the level around this component. */
export const useSolverSession = (): SolverSession => solverSessionOf(useEditor(), useLevel());
