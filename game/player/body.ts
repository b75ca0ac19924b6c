import { isJump, type RunEvent, type Simulation, STATE_SIZE, TICK, type Touched } from '../../engine/index.ts';
import type { Level, Place } from '../../schema/basics/index.ts';

/** Places closer to each other than this have no direction between them. */
const NO_DIRECTION = 1e-6;

/**
 * The states of a simulation before and after its last tick, and everything between them. Reading allocates nothing.
 */
export class Body {
  // both in one array, as `isJump` reads them
  private readonly both = new Float64Array(2 * STATE_SIZE);
  readonly previous: Float64Array = this.both.subarray(0, STATE_SIZE);
  readonly state: Float64Array = this.both.subarray(STATE_SIZE);
  /** x, y (px) and alive (1 or 0) of every alien before and after the tick. */
  private readonly aliensBefore: Float64Array;
  private readonly aliens: Float64Array;
  /** x, y (px) of every asteroid before and after the tick, if they can move. */
  private readonly asteroidsBefore: Float64Array;
  private readonly asteroids: Float64Array;

  /** Whether asteroids can move. */
  private readonly moves: boolean;

  constructor(private readonly simulation: Simulation) {
    const { level } = simulation.scene;
    this.moves = level.recoil && level.asteroids.length > 0;
    this.aliens = new Float64Array(3 * level.aliens.length);
    this.aliensBefore = this.aliens.slice();
    this.asteroids = new Float64Array(2 * level.asteroids.length);
    this.asteroidsBefore = this.asteroids.slice();
    this.jump();
  }

  /** Takes the present state for both, so that nothing is drawn between them: where a play begins. */
  jump(): void {
    const { simulation, aliens, asteroids } = this;
    simulation.readState(this.state);
    simulation.readAliens(aliens);
    simulation.readAsteroids(asteroids);
    this.previous.set(this.state);
    this.aliensBefore.set(aliens);
    this.asteroidsBefore.set(asteroids);
  }

  /** Takes the present state; the one before becomes `previous`. */
  step(): void {
    const { simulation, both, aliens, asteroids } = this;
    for (let i = 0; i < STATE_SIZE; i++) both[i] = both[STATE_SIZE + i];
    simulation.readState(this.state);
    // aliens that have not stirred are the same before and after
    if (aliens.length > 0 && simulation.mayAliensHaveStirred) {
      this.aliensBefore.set(aliens);
      simulation.readAliens(aliens);
    }
    if (this.moves) {
      this.asteroidsBefore.set(asteroids);
      simulation.readAsteroids(asteroids);
    }
  }

  /** Copies all of both states, to go back to them by {@link Body.paste}. */
  copy(): Float64Array[] {
    return [this.both, this.aliensBefore, this.aliens, this.asteroidsBefore, this.asteroids].map((numbers) => numbers.slice());
  }

  /** Goes back to a copy. */
  paste([both, aliensBefore, aliens, asteroidsBefore, asteroids]: readonly Float64Array[]): void {
    this.both.set(both);
    this.aliensBefore.set(aliensBefore);
    this.aliens.set(aliens);
    this.asteroidsBefore.set(asteroidsBefore);
    this.asteroids.set(asteroids);
  }

  /** Writes x, y (px), vx, vy (px/s), cos, sin of her at `alpha` between the two states. */
  readPose(alpha: number, out: Float64Array): void {
    const { both } = this;
    // there is no place between the two ends of a jump
    const t = isJump(both, 0, STATE_SIZE, TICK) ? Math.round(alpha) : alpha;
    for (let i = 0; i < STATE_SIZE; i++) out[i] = both[i] + t * (both[STATE_SIZE + i] - both[i]);
    const length = Math.sqrt(out[4] * out[4] + out[5] * out[5]);
    const turnsBack = length < NO_DIRECTION;
    out[4] = turnsBack ? this.state[4] : out[4] / length;
    out[5] = turnsBack ? this.state[5] : out[5] / length;
  }

  /** Writes x, y (px) and alive of every alien at `alpha` between the two states. */
  readAliens(alpha: number, out: Float64Array): void {
    const { aliensBefore, aliens } = this;
    for (let i = 0; i < aliens.length; i += 3) {
      out[i] = aliensBefore[i] + alpha * (aliens[i] - aliensBefore[i]);
      out[i + 1] = aliensBefore[i + 1] + alpha * (aliens[i + 1] - aliensBefore[i + 1]);
      out[i + 2] = aliens[i + 2];
    }
  }

  /** Writes x, y (px) of every asteroid at `alpha` between the two states. */
  readAsteroids(alpha: number, out: Float64Array): void {
    const { asteroidsBefore, asteroids } = this;
    for (let i = 0; i < asteroids.length; i++) out[i] = asteroidsBefore[i] + alpha * (asteroids[i] - asteroidsBefore[i]);
  }

  /** x of an alien after the tick, px. */
  alienX(i: number): number {
    return this.aliens[3 * i];
  }

  /** y of an alien after the tick, px. */
  alienY(i: number): number {
    return this.aliens[3 * i + 1];
  }

  /** x of an asteroid after the tick, px. */
  asteroidX(i: number): number {
    return this.asteroids[2 * i];
  }

  /** y of an asteroid after the tick, px. */
  asteroidY(i: number): number {
    return this.asteroids[2 * i + 1];
  }
}

const her = ({ state }: Body): Place => ({ x: state[0], y: state[1] });

/** The point of the object that is nearest to her. */
function contact(level: Level, body: Body, { kind, index }: Touched): Place {
  if (kind === 'blackHole') return level.blackHole;
  const list = kind === 'nova' ? level.novae : kind === 'alien' ? level.aliens : level.asteroids;
  const { radius } = list[index];
  const isAlien = kind === 'alien';
  const x = isAlien ? body.alienX(index) : kind === 'nova' ? list[index].x : body.asteroidX(index);
  const y = isAlien ? body.alienY(index) : kind === 'nova' ? list[index].y : body.asteroidY(index);
  const [dx, dy] = [body.state[0] - x, body.state[1] - y];
  const part = radius / Math.max(radius, Math.sqrt(dx * dx + dy * dy));
  return { x: x + part * dx, y: y + part * dy };
}

/** Where a game shows an event. `body` is in the state after the tick of the event. */
export function eventPlace(level: Level, body: Body, event: RunEvent): Place {
  switch (event.type) {
    case 'mineral':
      return level.minerals[event.index];
    case 'target':
      return { x: body.asteroidX(event.index), y: body.asteroidY(event.index) };
    case 'wake':
    case 'sleep':
      return { x: body.alienX(event.index), y: body.alienY(event.index) };
    case 'explosion': {
      const [a, b] = event.aliens;
      return { x: (body.alienX(a) + body.alienX(b)) / 2, y: (body.alienY(a) + body.alienY(b)) / 2 };
    }
    case 'completed':
    case 'collided':
    case 'lost':
      return event.with === null ? her(body) : contact(level, body, event.with);
    default:
      return her(body);
  }
}

/**
 * The number of different minerals that she has collected. `mineralCount` counts what the original game counts: of several
 * minerals touched in one frame all, and the next frame those again that it has not removed.
 * @param events what has happened since the start
 * @param count minerals in the level
 */
export function countCollected(simulation: Pick<Simulation, 'isCollected'>, events: readonly RunEvent[], count: number): number {
  const collected = new Set<number>();
  for (const event of events) if (event.type === 'mineral') collected.add(event.index);
  // one that she touches at the start may come without an event
  for (let i = 0; i < count; i++) if (simulation.isCollected(i)) collected.add(i);
  return collected.size;
}
