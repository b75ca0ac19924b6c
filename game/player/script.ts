import { joinHolds } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';

/** Holds that are read tick by tick. */
export class Script {
  private readonly holds: readonly Hold[];
  private next = 0;

  constructor(holds: readonly Hold[]) {
    this.holds = joinHolds(holds);
  }

  /** Whether the gun is held in a tick. Reading in order takes constant time. */
  isHeldAt(tick: number): boolean {
    const { holds } = this;
    if (this.next > 0 && tick < holds[this.next - 1][1]) this.next = 0;
    while (this.next < holds.length && holds[this.next][1] <= tick) this.next++;
    return this.next < holds.length && holds[this.next][0] <= tick;
  }
}
