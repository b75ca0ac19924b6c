import { createSimulation, joinHolds, maxTicksOf, type Scene, STATE_SIZE } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Ghost, type OpenLevel, putGhosts } from '../../core/context/index.ts';
import type { SearchState } from './search-session.ts';

/** The runs of a search as ghosts on the canvas. */
interface CandidateGhosts {
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

/**
 * The path of some holds: x, y in px at every tick and at the end.
 * @param until the last tick
 */
export function wayOf(scene: Scene, holds: readonly Hold[], until: number = maxTicksOf(scene.terms)): Float32Array {
  const simulation = createSimulation(scene);
  const script = joinHolds(holds);
  const state = new Float64Array(STATE_SIZE);
  const points: number[] = [];
  const see = () => {
    simulation.readState(state);
    points.push(state[0], state[1]);
  };
  see();
  let next = 0;
  while (simulation.ending === null && simulation.tick < until) {
    const { tick } = simulation;
    while (next < script.length && script[next][1] <= tick) next++;
    simulation.advance(1, next < script.length && script[next][0] <= tick);
    see();
  }
  return Float32Array.from(points);
}

/** A path known at every `ticks` ticks, interpolated linearly to one entry per tick. */
export function everyTick(points: Float32Array, ticks: number): Float32Array {
  const count = points.length / 2;
  if (count < 2) return points;
  const filled = new Float32Array(2 * ((count - 1) * ticks + 1));
  for (let i = 0; i < count - 1; i++) {
    for (let k = 0; k <= ticks; k++) {
      const share = k / ticks;
      const o = 2 * (i * ticks + k);
      filled[o] = points[2 * i] * (1 - share) + points[2 * i + 2] * share;
      filled[o + 1] = points[2 * i + 1] * (1 - share) + points[2 * i + 3] * share;
    }
  }
  return filled;
}
