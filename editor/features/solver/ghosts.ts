import { maxTicksOf, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Ghost, type OpenLevel, putGhosts } from '../../core/context/index.ts';
import { follow, type Solving } from '../../workers/index.ts';

/** What is drawn of a search. */
interface DrawnSearch {
  readonly found: readonly { readonly id: string; readonly candidate: { readonly holds: readonly Hold[] } }[];
  /** The id of the only run that is drawn; null: all are. */
  readonly hovered: string | null;
  readonly solving: Pick<Solving, 'closest'> | null;
  /** A proof that there is no run; null: there is none. */
  readonly impossible: object | null;
}

/** The runs of a search as ghosts on the canvas. */
interface CandidateGhosts {
  /** Draws the runs found, or only the hovered one; while there is none, the closest approach. */
  draw(scene: Scene, search: DrawnSearch): void;
  clear(): void;
}

export function createCandidateGhosts({ ghosts: shown }: Pick<OpenLevel, 'ghosts'>): CandidateGhosts {
  // each path is simulated once per scene
  let played: { readonly scene: Scene; readonly paths: Map<string, Float32Array> } | null = null;
  const pathIn = (scene: Scene, holds: readonly Hold[], until?: number): Float32Array => {
    if (played?.scene !== scene) played = { scene, paths: new Map() };
    const key = `${holds.join()} ${until}`;
    const path = played.paths.get(key) ?? pathOfHolds(scene, holds, until);
    played.paths.set(key, path);
    return path;
  };
  const ghostOf = (id: string, label: string, points: Float32Array): Ghost => ({ id, label, points, look: 'candidate' });
  return {
    draw(scene, { found, hovered, solving, impossible }) {
      const ghosts = found
        .filter(({ id }) => hovered === null || hovered === id)
        .map(({ id, candidate }, i) => ghostOf(`found-${id}`, `found ${i + 1}`, pathIn(scene, candidate.holds)));
      const closest = solving?.closest ?? null;
      if (found.length === 0 && closest !== null && impossible === null)
        ghosts.push(ghostOf('closest', 'closest approach', pathIn(scene, closest.holds, closest.tick + 1)));
      putGhosts(shown, 'candidate', ghosts);
    },
    clear: () => putGhosts(shown, 'candidate', []),
  };
}

/**
 * The path of some holds: x, y in px at every tick and at the end.
 * @param until the last tick
 */
export function pathOfHolds(scene: Scene, holds: readonly Hold[], until: number = maxTicksOf(scene.terms)): Float32Array {
  const steps = follow(scene, holds, until);
  for (;;) {
    const { done, value } = steps.next();
    if (done) return value.points;
  }
}
