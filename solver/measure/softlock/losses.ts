import { type Examined, type LostPlace, leadsThrough } from './state.ts';

/** Places nearer than this to each other are one, px. */
const NEAR = 48;

/** A moment at which a run is lost, with how it is known, and the states that are lost with it. */
interface Loss {
  readonly at: Examined;
  readonly open: number | null;
  readonly states: Set<Examined>;
  alive: number;
}

/** The moments at which states were lost, and the places where that happens. */
export class Losses {
  private all: Loss[] = [];

  /** The loss that a state lies beyond, if it was found already. */
  of(state: Examined): Loss | undefined {
    return this.all.find(
      ({ at }) => at.standing.is === state.standing.is && at.tick <= state.tick && leadsThrough(state.holds, at.holds, at.tick),
    );
  }

  /** Notes the moment at which a state was lost. */
  add(at: Examined, open: number | null, state: Examined): void {
    const alive = Math.max(at.alive, state.tick + state.alive - at.tick);
    this.all.push({ at, open, states: new Set([state]), alive });
  }

  /** Notes that a state lies beyond a loss. */
  follow(loss: Loss, state: Examined): void {
    loss.states.add(state);
    loss.alive = Math.max(loss.alive, state.tick + state.alive - loss.at.tick);
  }

  /** The states at which it was lost, as far as they are found. */
  moments(): Examined[] {
    return this.all.map(({ at }) => at);
  }

  /** Forgets those from which a run was found since. */
  dropOpen(): void {
    this.all = this.all.filter(({ at }) => at.standing.is !== 'open');
  }

  /** The places where it was lost, those first after which she lives on longest. */
  places(): LostPlace[] {
    const places: LostPlace[] = [];
    const isLost = ({ standing: { is } }: Examined) => is === 'proved' || is === 'not found';
    const sorted = this.all.filter(({ at }) => isLost(at)).sort((a, b) => b.alive - a.alive);
    for (const { at, open, states, alive } of sorted) {
      const near = places.findIndex(
        ({ x, y, standing }) => standing.is === at.standing.is && (x - at.x) * (x - at.x) + (y - at.y) * (y - at.y) < NEAR * NEAR,
      );
      if (near >= 0) places[near] = { ...places[near], states: places[near].states + states.size };
      else {
        const { x, y, holds, tick, standing, run } = at;
        places.push({ x, y, holds, tick, standing, run, alive, open, states: states.size });
      }
    }
    return places;
  }
}
