import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Ghost, type OpenLevel, putGhosts } from '../../core/context/index.ts';
import type { SearchState } from './search-state.ts';
import { wayOf } from './ways.ts';

/** The runs of a search as ghosts on the canvas. */
export interface CandidateGhosts {
  /** Draws the runs found, or only the hovered one; while there is none, the closest approach. */
  draw(scene: Scene, state: Pick<SearchState, 'found' | 'hovered' | 'solving' | 'impossible'>): void;
  clear(): void;
}

export function createCandidateGhosts({ ghosts: shown }: Pick<OpenLevel, 'ghosts'>): CandidateGhosts {
  // each path is simulated once per scene
  let played: { readonly scene: Scene; readonly ways: Map<string, Float32Array> } | null = null;
  const wayFor = (scene: Scene, holds: readonly Hold[], until?: number): Float32Array => {
    if (played?.scene !== scene) played = { scene, ways: new Map() };
    const key = `${holds.join()} ${until}`;
    const way = played.ways.get(key) ?? wayOf(scene, holds, until);
    played.ways.set(key, way);
    return way;
  };
  return {
    draw(scene, { found, hovered, solving, impossible }) {
      const ghosts = found
        .filter(({ id }) => hovered === null || hovered === id)
        .map(
          ({ id, candidate }, i): Ghost => ({
            id: `found-${id}`,
            label: `found ${i + 1}`,
            points: wayFor(scene, candidate.holds),
            look: 'candidate',
          }),
        );
      const closest = solving?.closest ?? null;
      if (found.length === 0 && closest !== null && impossible === null) {
        const points = wayFor(scene, closest.holds, closest.tick + 1);
        ghosts.push({ id: 'closest', label: 'closest approach', points, look: 'candidate' });
      }
      putGhosts(shown, 'candidate', ghosts);
    },
    clear: () => putGhosts(shown, 'candidate', []),
  };
}
