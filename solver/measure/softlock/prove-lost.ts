import { type AccuracyName, isAccuracyName, type Simulation, STATE_SIZE, TICK, WorkBudget } from '../../../engine/index.ts';
import { KINDS, type Level, LISTED_KINDS, NO_OBJECTS, objectsIn } from '../../../schema/basics/index.ts';
import { type Proof, type ProveOptions, type Prover, type ProverEntry, proveBy, proversThat } from '../../prove/index.ts';
import { type AnytimeProof, createAnytimeProof } from '../../search/anytime/index.ts';
import { verifyProof } from '../../verify/index.ts';

/** What the provers of one state may cost, pieces of motion. */
const MAX_WORK = 10_000;

/** The limit of `orbits` alone, pieces of motion: what it proves of such states, it proves with less. */
const ORBITS_WORK = 12_500;

/** A piece of motion of the provers takes about as long as so many ticks of a search. */
const TICKS_A_PIECE = 10;
const ORBITS_TICKS_A_PIECE = 16;

/** What is known about a state in which a run can be, as a level that starts there. */
interface StateLevel {
  /** Whatever she can do from the state, she can do in this level. */
  readonly level: Level;
  /** Whether the state is one in which the level can start, down to the angle of her box. */
  readonly isUpright: boolean;
}

/**
 * Makes a level that starts in the state of a run. A level has no angle, no asteroid that moves and no alien that is awake, so:
 *
 * - A level starts upright. Where the state is not, only provers that do not depend on the angle may be used.
 * - Aliens only end runs. Once one may have moved, all are left out: without them she can do no less.
 * - Minerals change no motion, so it does not matter which of them she has.
 * - An asteroid that recoil has moved may move on, and she may just have come out of what leads to another place: then there is
 *   no such level.
 * @returns null when there is none
 */
export function levelFrom(simulation: Simulation): StateLevel | null {
  const { level, accuracy } = simulation.scene;
  // frames carry the acceleration of the last frame over
  if (accuracy.integrator === 'arcade' || hasTwoPlaces(level) || hasRecoiled(simulation)) return null;
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  const [x, y, vx, vy, cos, sin] = state;
  const aliens = simulation.mayAliensHaveStirred ? NO_OBJECTS.aliens : level.aliens;
  return {
    level: { ...level, aliens, runs: [], astronaut: { ...level.astronaut, x, y, vx, vy } },
    isUpright: cos === 1 && sin === 0,
  };
}

/** Whether something leads from one place to another: she may have come out of it a moment ago. */
const hasTwoPlaces = (level: Level): boolean =>
  LISTED_KINDS.some((kind) => KINDS[kind].places.length > 1 && objectsIn(level, kind).length > 0);

function hasRecoiled(simulation: Simulation): boolean {
  const { asteroids, recoil } = simulation.scene.level;
  if (!recoil) return false;
  const places = new Float64Array(2 * asteroids.length);
  simulation.readAsteroids(places);
  return asteroids.some(({ x, y }, i) => places[2 * i] !== x || places[2 * i + 1] !== y);
}

/** What {@link proveLost} found. */
export interface LostProof {
  /** A proof about the level that starts in the state; the separate checker has confirmed it. null: none was found. */
  readonly proof: Proof | null;
  /** The level that the proof is about; null without a proof. */
  readonly level: Level | null;
  /** What the provers cost, ticks of a search that take about as long. */
  readonly ticks: number;
}

/**
 * Tries to prove that the black hole cannot be reached from the state of a run, whatever is pressed.
 * @param simulation a run in progress; it is not changed
 * @param maxTicks the longest run, ticks from the state on
 * @param alive the longest that she was seen alive after the state, ticks
 */
export const proveLost = (simulation: Simulation, maxTicks: number, alive: number): LostProof =>
  proveWith(simulation, maxTicks, alive, {
    is: ({ takes }) => takes !== 'longest',
    work: MAX_WORK,
    ticksAPiece: TICKS_A_PIECE,
  });

/**
 * The same by `orbits`, which costs more, and covers states from which she lives on longer.
 * @param simulation a run in progress; it is not changed
 * @param maxTicks the longest run, ticks from the state on
 * @param alive the longest that she was seen alive after the state, ticks
 */
export const proveLostByOrbits = (simulation: Simulation, maxTicks: number, alive: number): LostProof =>
  proveWith(simulation, maxTicks, alive, {
    is: ({ takes }) => takes === 'longest',
    work: ORBITS_WORK,
    ticksAPiece: ORBITS_TICKS_A_PIECE,
  });

/** Which provers are tried, and what they may cost. */
interface Means {
  readonly is: (prover: ProverEntry) => boolean;
  /** Pieces of motion. */
  readonly work: number;
  readonly ticksAPiece: number;
}

function proveWith(simulation: Simulation, maxTicks: number, alive: number, { is, work, ticksAPiece }: Means): LostProof {
  const { name } = simulation.scene.accuracy;
  const from = isAccuracyName(name) ? levelFrom(simulation) : null;
  if (from === null) return { proof: null, level: null, ticks: 0 };
  const budget = new WorkBudget(work);
  const options = { accuracy: name as AccuracyName, maxTime: maxTicks * TICK, budget };
  const proof = proveWithin(proversFor(from, alive, is), from.level, options);
  return { proof, level: proof === null ? null : from.level, ticks: ticksAPiece * budget.spent };
}

/**
 * The provers of some kind that cover a state.
 * @param alive the longest that she was seen alive after it, ticks
 */
function proversFor({ isUpright }: StateLevel, alive: number, is: (prover: ProverEntry) => boolean): Prover[] {
  const covering = (kind: ProverEntry['holdsFor']) =>
    proversThat((prover) => prover.holdsFor === kind && alive * TICK <= prover.within && is(prover));
  return isUpright ? [...covering('all states'), ...covering('upright states')] : covering('all states');
}

/** The first proof that a prover finds and the separate checker confirms; null if there is none within the budget. */
function proveWithin(
  provers: readonly Prover[],
  level: Level,
  options: ProveOptions & { readonly budget: WorkBudget },
): Proof | null {
  for (const prover of provers) {
    if (options.budget.isUsedUp) return null;
    const proof = proveBy(prover, level, { kind: 'blackHole' }, options);
    if (proof !== null && verifyProof(level, proof).ok) return proof;
  }
  return null;
}

/**
 * Begins a search for a proof with ever finer sets that the black hole cannot be reached from the state of a run.
 * @param simulation a run in progress; it is not changed
 * @param maxTicks the longest run, ticks from the state on
 * @param alive the longest that she was seen alive after the state, ticks
 * @returns null if no prover covers the state
 */
export function createLongProof(simulation: Simulation, maxTicks: number, alive: number): AnytimeProof | null {
  const { name } = simulation.scene.accuracy;
  const from = isAccuracyName(name) ? levelFrom(simulation) : null;
  if (from === null) return null;
  const provers = proversFor(from, alive, ({ finest }) => finest > 0);
  return provers.length === 0 ? null : createAnytimeProof(from.level, { accuracy: name as AccuracyName, maxTicks, provers });
}
