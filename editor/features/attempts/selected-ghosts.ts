import { useEffect, useMemo } from 'react';
import { useStore } from 'zustand';
import type { StoreApi } from 'zustand/vanilla';
import { type Desk, keepAnswers, onDemand } from '../../core/ask/index.ts';
import type { Attempt } from '../../core/attempts/index.ts';
import { attemptGhosts, type Ghost, putGhosts, useEditor, useLevel } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { type OpenedPlay, shelfOf } from '../../core/shelf/index.ts';
import { termsAt } from '../../core/terms/index.ts';
import { type AskedOf, jobs } from '../../workers/index.ts';

/** Paths that are shown at once: more of them are a tangle. */
const MOST = 40;

/** Paths of plays that are kept, to show them again at once. */
const KEPT = 200;

/** Her path in a play. */
export const pathQuestion = onDemand(jobs.path);

interface SelectedGhosts {
  /** Shows the paths of these attempts and plays. Those of plays are computed by a worker. @param played the level that was played */
  show(played: Pick<LiveProof, 'level' | 'terms'>, attempts: readonly Attempt[], plays: readonly OpenedPlay[]): void;
  close(): void;
}

interface Parts {
  readonly ghosts: StoreApi<readonly Ghost[]>;
  readonly desk: Desk;
}

function createSelectedGhosts({ ghosts, desk }: Parts): SelectedGhosts {
  const paths = keepAnswers(desk, {
    ask: pathQuestion,
    of: (wanted: AskedOf<typeof jobs.path>) => wanted,
    value: ({ answer }) => answer?.points ?? null,
    first: 'earliest',
    most: KEPT,
  });
  let draw = () => {};
  paths.store.subscribe(({ byKey }, before) => byKey !== before.byKey && draw());
  return {
    show({ level, terms }, attempts, plays) {
      paths.stop();
      const own = attemptGhosts(attempts).map((ghost): Ghost => ({ ...ghost, id: `selected-${ghost.id}`, look: 'selected' }));
      const shown = plays.slice(0, MOST);
      draw = () => {
        const { byKey } = paths.store.getState();
        const others = shown.flatMap(({ key, source }): Ghost[] => {
          const points = byKey.get(key);
          return points === undefined ? [] : [{ id: `selected-${key}`, label: source, points, look: 'selected' }];
        });
        putGhosts(ghosts, 'selected', [...own, ...others]);
      };
      draw();
      for (const { key, play } of shown) {
        const { accuracy, holds, claim } = play;
        paths.want(key, { level, terms: termsAt(terms, accuracy), holds, until: claim.tick });
      }
    },
    close() {
      paths.stop();
      draw = () => {};
      putGhosts(ghosts, 'selected', []);
    },
  };
}

/** Shows what is selected in the list of attempts on the canvas, whichever panel is in front. */
export function AttemptsWatch() {
  const { desk } = useEditor();
  const level = useLevel();
  const { store } = shelfOf(level);
  const attempts = useStore(level.attempts.store);
  const plays = useStore(store, (state) => state.plays);
  const selected = useStore(store, (state) => state.selected);
  const of = useStore(store, (state) => state.of);
  const ghosts = useMemo(() => createSelectedGhosts({ ghosts: level.ghosts, desk }), [level, desk]);
  useEffect(() => {
    const { level: now, terms } = level.proof.proof();
    const own = attempts.filter(({ number }) => selected.has(`attempt-${number}`));
    ghosts.show(
      { level: of?.level ?? now, terms },
      own,
      plays.filter(({ key }) => selected.has(key)),
    );
  }, [ghosts, level, of, attempts, plays, selected]);
  useEffect(() => () => ghosts.close(), [ghosts]);
  return null;
}
