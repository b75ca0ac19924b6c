import type { StoreApi } from 'zustand/vanilla';
import { type Desk, keepAnswers, question } from '../../core/ask/index.ts';
import type { Attempt } from '../../core/attempts/index.ts';
import { attemptGhosts, type Ghost, putGhosts } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import type { OpenedPlay } from '../../core/shelf/index.ts';
import { termsAt } from '../../core/terms/index.ts';
import { type AskedOf, jobs } from '../../workers/index.ts';

/** Paths that are shown at once: more of them are a tangle. */
const MOST = 40;

/** Paths of plays that are kept, to show them again at once. */
const KEPT = 200;

/** Her path in a play. */
export const pathQuestion = question({ job: jobs.path, request: (of: AskedOf<typeof jobs.path>) => of });

export interface SelectedGhosts {
  /** Shows the paths of these attempts and plays. Those of plays are computed by a worker. @param played the level that was played */
  show(played: Pick<LiveProof, 'level' | 'terms'>, attempts: readonly Attempt[], plays: readonly OpenedPlay[]): void;
  close(): void;
}

interface Parts {
  readonly ghosts: StoreApi<readonly Ghost[]>;
  readonly desk: Desk;
}

export function createSelectedGhosts({ ghosts, desk }: Parts): SelectedGhosts {
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
