import {
  type BodyKind,
  compile,
  createSimulation,
  joinHolds,
  maxTicksOf,
  playScript,
  type RunEvent,
  type Scene,
  STATE_SIZE,
  type Terms,
  type Touched,
  WorkBudget,
} from '../../engine/index.ts';
import { claimInWords, levelHash, type Play, whyNotReplayed } from '../../game/play/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type Goal, mineralsNeeded } from '../../solver/index.ts';
import { withinWork } from '../within-work.ts';
import type { Attempt, FailureCause, RefusedPlay } from './attempt.ts';
import { routeOf } from './routes.ts';

/** Simulates plays of one level again, each once. */
export interface PlayReplayer {
  /**
   * Simulates a play and compares it with its claim. Only the holds are trusted.
   * @param play the play
   * @param index its index within all plays
   * @returns what it turned out to be, or why it does not count
   */
  replay(play: Play, index: number): Attempt | RefusedPlay;
}

/**
 * Prepares a level for the replay of its plays. Only plays under the given terms count: others would say how another game plays.
 * @param level the level
 * @param terms at which accuracy plays must have been played, how long they may last, and what a replay may cost
 * @param goal what an attempt has to achieve
 */
export function createPlayReplayer(level: Level, terms: Terms, goal: Goal): PlayReplayer {
  const acceptance = { hash: levelHash(level), accuracy: terms.accuracy.name, maxTicks: maxTicksOf(terms) };
  let stage: Stage | null = null;
  return {
    replay(play, index) {
      const refuse = (verdict: RefusedPlay['verdict'], message: string): RefusedPlay => ({ play: index, verdict, message });
      const { holds, claim } = play;
      const why = whyNotReplayed(play, acceptance);
      if (why !== null) return refuse(why.verdict, why.message);
      stage ??= new Stage(compile(level, terms), goal);
      const attempt = stage.attempt(holds, claim.tick, claim.outcome === 'timeout' ? 'timeout' : 'left', index);
      if (attempt === null) return refuse('too-long', `simulating it takes more work than ${terms.maxWork} pieces of motion`);
      const { counted } = stage;
      if (attempt.outcome === claim.outcome && attempt.tick === claim.tick && counted === claim.minerals) return attempt;
      const found = claimInWords({ ...attempt, minerals: counted }, attempt.minerals);
      return refuse('claim-differs', `expected ${claimInWords(claim)}, as the play claims; found ${found}`);
    },
  };
}

/** A scene on which attempts are played, one after the other. */
export class Stage {
  private readonly events: RunEvent[] = [];
  private readonly budget: WorkBudget;
  private readonly state = new Float64Array(STATE_SIZE);
  private readonly simulation;
  private readonly needed: number;

  constructor(scene: Scene, goal: Goal) {
    this.budget = new WorkBudget(scene.terms.maxWork);
    this.simulation = createSimulation(scene, this.budget, this.events);
    this.needed = mineralsNeeded(goal, scene.minerals.count);
  }

  /** Minerals of the last attempt as the game counts them: at the accuracy `arcade` it may count one twice. */
  get counted(): number {
    return this.simulation.mineralCount;
  }

  /**
   * Plays an attempt.
   * @param holds [press, release) in ticks
   * @param until the tick at which it is over if it has not ended by then
   * @param open how it ends in that case
   * @param index its index within all plays
   * @returns the attempt, or null if it is too much work
   */
  attempt(holds: readonly Hold[], until: number, open: 'timeout' | 'left', index: number): Attempt | null {
    const { simulation, budget, events, state } = this;
    simulation.reset();
    budget.looks = 0;
    events.length = 0;
    const joined = joinHolds(holds);
    const isPlayed = withinWork(budget, () => {
      playScript(simulation, joined, until);
      return true;
    });
    if (isPlayed === null) return null;
    const { tick } = simulation;
    // who leaves before the first tick has not seen what ends the play at once
    const ending = until === 0 && open === 'left' ? null : simulation.ending;
    const outcome = ending?.outcome ?? open;
    const minerals = new Set(events.flatMap((event) => (event.type === 'mineral' ? event.index : []))).size;
    simulation.readState(state);
    return {
      play: index,
      outcome,
      cause: causeOf(outcome, ending?.with ?? null, minerals >= this.needed),
      x: state[0],
      y: state[1],
      tick,
      time: simulation.time,
      minerals,
      // a hold that lasts to the end has no release
      edges: joined.flat().filter((edge) => edge < tick),
      route: routeOf(events),
    };
  }
}

function causeOf(outcome: Attempt['outcome'], touched: Touched | null, hasMinerals: boolean): FailureCause | null {
  if (outcome === 'completed') return hasMinerals ? null : { kind: 'minerals', index: null };
  if (outcome !== 'collided') return { kind: outcome, index: null };
  if (touched === null) throw new Error('a collision without an object');
  return { kind: touched.kind as Exclude<BodyKind, 'blackHole'>, index: touched.index };
}
