import { Places } from './places.ts';
import { type Chart, type Drifts, ROUNDING, type Rock, type Scene } from './scene.ts';

/** Who may come nearer than this to an asteroid within a step, px, has coordinates in x and y. */
const PASS = 16;

/** Nearer to an asteroid than this, px, boxes are in x and y; further away if she is fast. */
export const CLOSE = 32;

/** The least distance for polar coordinates, as a share of how far she can go within a step. */
export const SHARE = 0.25;

/** The asteroid of the chart. */
export const OWN = -1;

/** Where a set of places lies among everything at one time: in a hazard, out of range, nearest to which asteroid. */
export class Whereabouts {
  private readonly scene: Scene;
  /** The places that are asked about. */
  readonly places = new Places();
  private readonly drifts: Drifts;

  constructor(scene: Scene, drifts: Drifts) {
    this.scene = scene;
    this.drifts = drifts;
  }

  /** How far she can go within a step, px. */
  flight(speed: number): number {
    const { seconds, push } = this.scene;
    return seconds * (speed + (push * seconds) / 2);
  }

  /**
   * Whether she may come close to the asteroid within a step, where polar coordinates are of no use.
   * @param inward - how fast she comes nearer at most, px/s
   */
  mayPassClose(distance: number, inward: number, speed: number, L0: number, L1: number): boolean {
    const { seconds, push } = this.scene;
    const gain = push * seconds;
    // at the nearest place, angular momentum is distance times speed
    return distance - seconds * (Math.max(0, inward) + gain) < PASS && Math.max(0, L0, -L1) < PASS * (speed + gain);
  }

  /** Whether all places of `places` lie in one hazard. */
  isBlocked({ blocked, rocks }: Chart, i: number): boolean {
    const { places, drifts } = this;
    for (const body of blocked) if (places.areWithin(body, body.radius - drifts.of(i) - ROUNDING)) return true;
    for (const rock of rocks) {
      if (rock.radius > 0 && places.areWithin(rock, rock.radius - drifts.between(i, rock.index) - ROUNDING)) return true;
    }
    return false;
  }

  /** Whether all places of `places` are out of range of all asteroids but that of the chart. */
  isOutOfOthers({ rocks }: Chart, i: number): boolean {
    const { places, drifts, scene } = this;
    for (const rock of rocks) {
      if (!places.areBeyond(rock, scene.range + drifts.between(i, rock.index) + ROUNDING)) return false;
    }
    return true;
  }

  /** OWN when the chart's asteroid may be the nearest at one of `places`; otherwise one that is certainly nearer. */
  nearest({ rocks }: Chart, i: number): number {
    const { places, drifts } = this;
    let best = OWN;
    let least = Number.POSITIVE_INFINITY;
    const farthest = drifts.farthestRival(places.most);
    for (const rock of rocks) {
      if (rock.r > farthest) break;
      places.look(rock.x, rock.y, rock.r);
      const slack = drifts.slack(drifts.between(i, rock.index), rock, places.most);
      if (places.dot0 > (rock.r * rock.r) / 2 + slack && places.far < least) {
        best = rock.index;
        least = places.far;
      }
    }
    return best;
  }

  /** Asteroid j in the chart of asteroid i. */
  rock(i: number, j: number): Rock {
    return this.scene.charts[i].rocks.find(({ index }) => index === j) as Rock;
  }
}
