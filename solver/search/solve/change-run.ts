import type { Hold } from '../../../schema/basics/index.ts';
import type { Random } from '../../random.ts';

/**
 * Makes a random variation of a run: drops a hold, shifts everything from one edge on, inserts a pause or a hold, cuts off the
 * end, or shakes all edges.
 */
export function changeRun(holds: readonly Hold[], random: Random): Hold[] {
  const edges = holds.flat();
  const between = (low: number, high: number) => low + random.below(Math.max(1, high - low));
  switch (random.below(5)) {
    case 0:
      if (edges.length > 2) edges.splice(2 * random.below(holds.length), 2);
      break;
    case 1: {
      const first = random.below(edges.length);
      const by = (random.below(2) === 0 ? 1 : -1) * between(4, 44);
      for (let i = first; i < edges.length; i++) edges[i] += by;
      break;
    }
    case 2: {
      // Insert two edges into a stretch: a pause into a hold, or a hold into a pause.
      const place = random.below(edges.length);
      const low = place === 0 ? 0 : edges[place - 1];
      if (edges[place] - low <= 20) break;
      const first = between(low + 4, edges[place] - 12);
      edges.splice(place, 0, first, between(first + 4, Math.min(first + 64, edges[place] - 2)));
      break;
    }
    case 3: {
      // Drop everything after one of the holds, and make that hold longer.
      const last = random.below(holds.length);
      edges.length = 2 * last + 2;
      edges[2 * last + 1] += 240;
      break;
    }
    default: {
      const size = between(10, 40);
      for (let i = 0; i < edges.length; i++) edges[i] += Math.round((random.unit() + random.unit() - 1) * size);
    }
  }
  return inOrder(edges);
}

/** Restores the order of edges by moving those that come too early. */
function inOrder(edges: readonly number[]): Hold[] {
  const holds: Hold[] = [];
  let last = -1;
  for (let i = 0; i < edges.length; i += 2) {
    const press = Math.max(last + 1, edges[i]);
    last = Math.max(press + 1, edges[i + 1]);
    holds.push([press, last]);
  }
  return holds;
}
