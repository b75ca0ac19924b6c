import { boxCircleGap, type Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/basics/index.ts';
import type { NodeList } from './node-list.ts';
import type { Closest } from './search.ts';

/** Records the closest approach to the black hole of all stretches. */
export class Approach {
  private readonly scene: Scene;
  private distance = Number.POSITIVE_INFINITY;
  private node = -1;
  private tick = 0;
  private held = false;
  private holds: readonly Hold[] | null = null;

  constructor(scene: Scene) {
    this.scene = scene;
  }

  /** Examines a state on a stretch from `node`. */
  look(state: Float64Array, node: number, tick: number, held: boolean): void {
    const { box, level } = this.scene;
    const hole = level.blackHole;
    const dx = hole.x - state[0];
    const dy = hole.y - state[1];
    const far = this.distance + hole.radius + box.halfDiagonal;
    if (dx * dx + dy * dy > far * far) return;
    const distance = Math.max(0, boxCircleGap(box, dx, dy, state[4], state[5], hole.radius));
    if (distance >= this.distance) return;
    this.distance = distance;
    this.node = node;
    this.tick = tick;
    this.held = held;
    this.holds = null;
  }

  /**
   * The closest approach. Its holds are derived on demand, because early in a search almost every state is a new minimum; ask
   * before the nodes are discarded.
   */
  closest(nodes: NodeList): Closest | null {
    if (this.node < 0) return null;
    this.holds ??= nodes.holdsTo(this.node, this.tick, this.held);
    return { distance: this.distance, tick: this.tick, holds: this.holds };
  }
}
