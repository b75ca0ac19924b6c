import type { StoreApi } from 'zustand/vanilla';
import type { Attempt } from '../../attempts/index.ts';
import type { Ghost } from '../../context/index.ts';
import { attemptGhosts } from '../../play/index.ts';
import type { LiveProof } from '../../proof/index.ts';
import type { OpenedPlay } from '../../shelf/index.ts';
import { termsAt } from '../../terms/index.ts';
import { jobs, type Workers } from '../../workers/index.ts';

/** Paths that are shown at once: more of them are a tangle. */
const MOST = 40;

/** Paths of plays that are kept, to show them again at once. */
const KEPT = 200;

export interface SelectedGhosts {
  /** Shows the paths of these attempts and plays. Those of plays are computed by a worker. @param played the level that was played */
  show(played: Pick<LiveProof, 'level' | 'terms'>, attempts: readonly Attempt[], plays: readonly OpenedPlay[]): void;
  close(): void;
}

interface Parts {
  readonly ghosts: StoreApi<readonly Ghost[]>;
  readonly workers: Pick<Workers, 'start'>;
}

export function createSelectedGhosts({ ghosts, workers }: Parts): SelectedGhosts {
  const paths = new Map<string, Float32Array>();
  let started: (() => void)[] = [];
  const cancel = () => {
    for (const stop of started) stop();
    started = [];
  };
  const put = (wanted: readonly Ghost[]) => {
    const now = ghosts.getState();
    const others = now.filter(({ look }) => look !== 'selected');
    if (wanted.length > 0 || others.length < now.length) ghosts.setState([...others, ...wanted], true);
  };
  return {
    show({ level, terms }, attempts, plays) {
      cancel();
      const own = attemptGhosts(attempts).map((ghost): Ghost => ({ ...ghost, id: `selected-${ghost.id}`, look: 'selected' }));
      const wanted = plays.slice(0, MOST);
      const draw = () => {
        const others = wanted.flatMap(({ key, source }): Ghost[] => {
          const points = paths.get(key);
          return points === undefined ? [] : [{ id: `selected-${key}`, label: source, points, look: 'selected' }];
        });
        put([...own, ...others]);
      };
      draw();
      for (const { key, play } of wanted) {
        if (paths.has(key)) continue;
        const { accuracy, holds, claim } = play;
        const job = workers.start(jobs.path, { level, terms: termsAt(terms, accuracy), holds, until: claim.tick });
        started.push(job.cancel);
        void job.end.then((end) => {
          if (end.kind !== 'done') return;
          if (paths.size >= KEPT) paths.delete(paths.keys().next().value ?? '');
          paths.set(key, end.result.points);
          draw();
        });
      }
    },
    close() {
      cancel();
      put([]);
    },
  };
}
