import {
  type Dd,
  dd,
  direction,
  divide,
  dot,
  length,
  minus,
  negate,
  plus,
  scaled,
  subtract,
  toNumber,
  type Vector,
  ZERO,
} from '../double-double.ts';
import { type Acting, type Along, actingIn, chases, rimOf, type Surroundings, timeToCentre } from '../forces.ts';
import { NotCovered, spend } from '../stretch.ts';
import { type Mover, placeOf, type World } from '../world.ts';
import { Step } from './collocation.ts';

/** The longest step, s, and the shortest; powers of 2. */
const LONGEST = 2;
const SHORTEST = 1e-12;

/** How a step that is tried first compares with the time in which a centre is reached. */
const SHARE = 0.35;

/** Everything that moves, at one moment. */
export interface Moment {
  readonly her: Mover;
  readonly box: Vector;
  /** Her acceleration as if there were no speed limit, px/s². */
  readonly force: Vector;
  /** While she slides on a rim: the share of the force inside. */
  readonly share: Dd | null;
  asteroid(index: number): Mover;
  alien(index: number): Mover;
}

/** The motion from now on, by Gauss collocation. */
export class Motion {
  /** Up to when it holds, s. */
  readonly reach: number;
  readonly besideCentre: number;
  readonly acting: Acting;
  /** The moment from which on. */
  readonly start: Moment;
  readonly #world: World;
  readonly #step: Step;
  /** Which asteroid, and which aliens, are bodies of the step after her. */
  readonly #drawn: number;
  readonly #chasing: readonly number[];
  readonly #start: readonly Mover[];

  constructor(world: World) {
    this.#world = world;
    const acting = actingIn(world);
    this.acting = acting;
    this.#drawn = acting.target !== null && acting.recoil.hi > 0 ? world.target : -1;
    this.#chasing = world.aliens.flatMap((alien, i) => (chases(alien) ? [i] : []));
    const bodies = [
      world.her,
      ...(this.#drawn < 0 ? [] : [world.asteroids[this.#drawn]]),
      ...this.#chasing.map((i) => world.aliens[i]),
    ];
    this.#start = bodies.map(({ at, velocity }) => ({ at, velocity }));
    const { lines, target, outside } = acting;
    const beside = (body: Mover | null, line: Along) =>
      body === null || line !== null ? Number.POSITIVE_INFINITY : toNumber(length(minus(body.at, world.her.at)));
    this.besideCentre = Math.min(beside(target, lines.gun), beside(outside.field, lines.field));
    const isFree = target === null && outside.field === null && world.slide === null && this.#chasing.length === 0;
    let reach = LONGEST;
    if (!isFree) {
      const longest = SHARE * timeToCentre(world, acting);
      while (reach > longest && reach > SHORTEST) reach /= 2;
    }
    const accelerations = (at: readonly Vector[], velocity: readonly Vector[]) => this.#accelerations(at, velocity);
    let step = Step.of(this.#start, accelerations, reach);
    while (step === null) {
      reach /= 2;
      if (reach < SHORTEST) throw new NotCovered('steps become too short');
      step = Step.of(this.#start, accelerations, reach);
    }
    this.#step = step;
    this.reach = reach;
    this.start = this.at(ZERO);
  }

  /** @param time - since the start of the stretch, s */
  at(time: Dd): Moment {
    const places = this.#step.at(time);
    const world = this.#world;
    const bodyAt = (i: number): Mover => ({ at: places.at[i], velocity: places.velocity[i] });
    const moved = ({ at, velocity }: Mover): Mover => ({ at: plus(at, scaled(velocity, time)), velocity });
    return {
      her: bodyAt(0),
      box: this.acting.turns ? this.#toTarget(places.at) : world.box,
      ...this.#force(places.at, places.velocity[0]),
      asteroid: (i) => (i === this.#drawn ? bodyAt(1) : moved(world.asteroids[i])),
      alien: (i) => {
        const chasing = this.#chasing.indexOf(i);
        return chasing < 0 ? moved(world.aliens[i]) : bodyAt(chasing + (this.#drawn < 0 ? 1 : 2));
      },
    };
  }

  /** What would act on her without a speed limit, and the share of the force inside of the rim on which she slides. */
  #force(at: readonly Vector[], velocity: Vector): { readonly force: Vector; readonly share: Dd | null } {
    const { inside, outside } = this.acting;
    const { slide } = this.#world;
    const beyond = this.#forceIn(outside, at);
    if (slide === null) return { force: beyond, share: null };
    // Filippov's combination: with the normal n outwards and speed v, n . force = -v^2 / radius
    const rim = rimOf(this.#world);
    const normal = scaled(minus(at[0], placeOf(rim)), divide(dd(1), dd(rim.radius)));
    const difference = minus(this.#forceIn(inside, at), beyond);
    const bend = divide(dot(velocity, velocity), dd(-rim.radius));
    const share = divide(subtract(bend, dot(normal, beyond)), dot(normal, difference));
    return { force: plus(beyond, scaled(difference, share)), share };
  }

  #forceIn({ field, wind }: Surroundings, at: readonly Vector[]): Vector {
    const { rules } = this.#world;
    const { lines, target, slope } = this.acting;
    if (field !== null) {
      const towards = lines.field ?? direction(minus(field.at, at[0]));
      return minus(wind, scaled(towards, dd(rules.push)));
    }
    if (target === null) return wind;
    const apart = minus(this.#targetIn(at), at[0]);
    return plus(wind, minus(scaled(this.#toTarget(at), dd(rules.pull)), scaled(apart, slope)));
  }

  /** Of a gun that is held. */
  #targetIn(at: readonly Vector[]): Vector {
    return this.#drawn < 0 ? this.acting.target!.at : at[1];
  }

  #toTarget(at: readonly Vector[]): Vector {
    return this.acting.lines.gun ?? direction(minus(this.#targetIn(at), at[0]));
  }

  #accelerations(at: readonly Vector[], velocity: readonly Vector[]): Vector[] {
    const { limits, rules } = this.#world;
    spend(this.#world, at.length - 1);
    const { force } = this.#force(at, velocity[0]);
    const made = [{ x: limits[0] === 0 ? force.x : ZERO, y: limits[1] === 0 ? force.y : ZERO }];
    if (this.#drawn >= 0) made.push(scaled(this.#toTarget(at), negate(this.acting.recoil)));
    for (let i = made.length; i < at.length; i++) made.push(scaled(direction(minus(at[0], at[i])), dd(rules.alienPull)));
    return made;
  }
}
