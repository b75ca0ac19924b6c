import type { Hold } from '../../../schema/basics/index.ts';
import type { Candidate, Replay } from '../../verified-run.ts';
import type { HeatMap } from './heat-map.ts';
import type { NodeList } from './node-list.ts';

/** How many runs are kept that press and release in about the same places. */
const ALIKE = 4;

/** The runs found. Each has been replayed from the start, and only a few similar ones are kept. */
export class Reports {
  readonly solutions: Candidate[] = [];
  private readonly replay: Replay;
  private readonly families = new Map<number, number>();
  private readonly scripts = new Set<string>();

  constructor(replay: Replay) {
    this.replay = replay;
  }

  /** Ticks simulated by the replays. */
  get ticks(): number {
    return this.replay.ticks;
  }

  /** Adds the run that passes through node `last` and goes on to tick `until` with the button held or not. */
  add(nodes: NodeList, heat: HeatMap, last: number, until: number, held: boolean): void {
    const family = familyOf(nodes, heat, last, held);
    const members = this.families.get(family) ?? 0;
    if (members >= ALIKE) return;
    if (this.addRun(nodes.holdsTo(last, until, held))) this.families.set(family, members + 1);
  }

  /**
   * Adds a run that is like no other.
   * @param holds [press, release) in ticks
   * @returns whether the run meets the goal and is new
   */
  addRun(holds: readonly Hold[]): boolean {
    const candidate = this.replay.play(holds);
    if (candidate === null) return false;
    // Paths through different cells may have the same holds.
    const script = candidate.holds.join(' ');
    if (this.scripts.has(script)) return false;
    this.scripts.add(script);
    this.solutions.push(candidate);
    return true;
  }
}

/** A hash that is equal for runs that press and release in about the same places. */
function familyOf(nodes: NodeList, heat: HeatMap, last: number, held: boolean): number {
  let family = held ? 1 : 2;
  let button = held;
  for (let n = last; n >= 0; n = nodes.parent[n]) {
    if (nodes.isHeld(n) === button && n !== last) continue;
    button = nodes.isHeld(n);
    family = Math.imul(family ^ heat.districtOf(nodes.square[n]), 0x9e3779b1);
  }
  return family;
}
