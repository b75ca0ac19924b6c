import {
  type AccuracyName,
  compile,
  createSimulation,
  DEFAULT_ACCURACY,
  DEFAULT_MAX_WORK,
  type Ending,
  type RunEvent,
  type Scene,
  TICK_RATE,
  WorkBudget,
  WorkLimitReached,
} from '../../engine/index.ts';
import type { Level } from '../../schema/basics/index.ts';
import { CHECKPOINT_TICKS, countCollected, PlayHash } from '../player/index.ts';
import { decodePlay } from './bytes.ts';
import { type ChallengeState, challengeState, expectSecret } from './challenge.ts';
import { levelHash } from './level-hash.ts';
import { isOpen, PLAY_LIMITS, type Play, type PlayClaim } from './play.ts';
import { type PlaySigns, signsOf } from './signs.ts';
import { type AcceptedAccuracy, claimInWords, whyNotReplayed } from './why-not-replayed.ts';

/** What a play is found to be. */
export const PLAY_VERDICTS = [
  'ok',
  'claim-differs',
  'stale-level',
  'other-accuracy',
  'unknown-engine',
  'malformed',
  'too-long',
] as const;

/**
 * What a play is found to be: `ok`, it is what it claims; `claim-differs`, its inputs lead to something else, or its challenge
 * does not hold; `stale-level`, it was played on another level or version of it; `other-accuracy`, at an accuracy that is not taken;
 * `unknown-engine`, with another engine or format; `malformed`, it is no play; `too-long`, it is larger, longer or more work than is allowed.
 */
export type PlayVerdict = (typeof PLAY_VERDICTS)[number];

/** Options of {@link verifyPlay}. */
export interface VerifyOptions {
  /**
   * The accuracy at which plays must have been played, {@link DEFAULT_ACCURACY} when left out; `any` takes all. Name the one of
   * your game: otherwise the sender chooses the physics.
   */
  readonly accuracy?: AcceptedAccuracy;
  /** Ticks that a play may have; one hour, 216,000, when left out. */
  readonly maxTicks?: number;
  /** Work that the replay may cost, pieces of motion; {@link DEFAULT_MAX_WORK} when left out. */
  readonly maxWork?: number;
  /** The server's secret, at least 16 random bytes; every play must then contain a challenge of it. */
  readonly challengeKey?: Uint8Array;
  /** For whom the challenge must have been given; '' when left out. */
  readonly challengeSubject?: string;
  /** The present time, seconds since 1970; required with `challengeKey`. */
  readonly now?: number;
}

/** Where a replay first differs from what a play says, as ticks of the play. */
export interface PlaySpan {
  /** The play agrees up to this tick. */
  readonly from: number;
  /** It differs at this tick, or before. */
  readonly to: number;
}

/** What {@link verifyPlay} finds. */
export interface VerifiedPlay {
  /** What the play is found to be. */
  readonly verdict: PlayVerdict;
  /** The verdict in words: what was expected and what was found. */
  readonly message: string;
  /** The play; null if the bytes can't be read. */
  readonly play: Play | null;
  /** What the inputs lead to; null unless they were replayed to the end. */
  readonly found: PlayClaim | null;
  /** How the replay ended, with the exact time; null if it had not ended by then, or was not replayed to the end. */
  readonly ending: Ending | null;
  /** Where the replay first differs; null unless the verdict is `claim-differs` because of the replay. */
  readonly differs: PlaySpan | null;
  /** What the challenge is worth; null if the bytes can't be read. */
  readonly challenge: ChallengeState | null;
  /** What may mean that the play is no person's; null unless the verdict is `ok`. */
  readonly signs: PlaySigns | null;
  /** Work that the replay cost, pieces of motion. */
  readonly work: number;
}

/** Verifies plays of one level: what the level costs is paid once. */
export interface PlayVerifier {
  /** The level. */
  readonly level: Level;
  /** Its hash. */
  readonly hash: string;
  /**
   * Verifies a play; see {@link verifyPlay}.
   *
   * @param bytes - the content of a `.gqr` file
   * @param options - accuracy, limits and challenge, where they differ from those of the verifier
   * @returns what the play is found to be
   */
  verify(bytes: Uint8Array, options?: VerifyOptions): VerifiedPlay;
}

interface Replayed {
  readonly found: PlayClaim;
  /** Different minerals that were collected, while `found` has those that the game counts. */
  readonly collected: number;
  readonly hash: string;
  readonly ending: Ending | null;
  /** The first checkpoint that differs, from 0; null if none does. */
  readonly wrong: number | null;
}

/** Plays the inputs of a play, up to its end or to the first checkpoint that differs. */
function replay(scene: Scene, play: Play, budget: WorkBudget): Replayed {
  const events: RunEvent[] = [];
  const taken: RunEvent[] = [];
  const simulation = createSimulation(scene, budget, events);
  // a player does not report what happens before its first tick
  events.length = 0;
  const hash = new PlayHash(simulation);
  const { tick: end, outcome } = play.claim;
  // the ticks at which the button changes
  const edges = play.holds.flat();
  let next = 0;
  let wrong: number | null = null;
  while (simulation.tick < end && simulation.ending === null && wrong === null) {
    const { tick } = simulation;
    while (next < edges.length && edges[next] <= tick) next++;
    // the last tick by itself, as a play ends in the first tick in which it can
    const last = tick < end - 1 ? end - 1 : end;
    const checkpoint = (Math.floor(tick / CHECKPOINT_TICKS) + 1) * CHECKPOINT_TICKS;
    const until = Math.min(last, checkpoint, next < edges.length ? edges[next] : end);
    simulation.advance(until - tick, next % 2 === 1);
    for (const event of events) {
      hash.event(event);
      if (event.type === 'mineral') taken.push(event);
    }
    events.length = 0;
    hash.tick();
    const { length } = hash.checkpoints;
    if (length > 0 && hash.checkpoints[length - 1] !== play.checkpoints[length - 1]) wrong = length - 1;
  }
  const ending = end === 0 && outcome === 'left' ? null : simulation.ending;
  const found: PlayClaim = {
    tick: simulation.tick,
    minerals: simulation.mineralCount,
    outcome: ending?.outcome ?? (isOpen(outcome) ? outcome : 'left'),
  };
  const collected = countCollected(simulation, taken, scene.minerals.count);
  return { found, collected, hash: hash.digest(found.outcome === 'left' ? '' : found.outcome), ending, wrong };
}

const seconds = (tick: number): string => (tick / TICK_RATE).toFixed(2);

const CHALLENGE_IN_WORDS = {
  missing: 'expected a challenge, found none',
  forged: 'expected a challenge that was given for this level and player, found another',
  expired: 'expected a challenge that is still valid, found one that has expired',
} as const;

/** See {@link createVerifier}. */
class LevelVerifier implements PlayVerifier {
  readonly hash: string;
  private readonly scenes = new Map<AccuracyName, Scene>();

  constructor(
    readonly level: Level,
    private readonly options: VerifyOptions,
  ) {
    this.hash = levelHash(level);
  }

  private scene(accuracy: AccuracyName): Scene {
    const scene = this.scenes.get(accuracy) ?? compile(this.level, accuracy);
    this.scenes.set(accuracy, scene);
    return scene;
  }

  verify(bytes: Uint8Array, own: VerifyOptions = {}): VerifiedPlay {
    const options = { ...this.options, ...own };
    const { accuracy = DEFAULT_ACCURACY, maxTicks = PLAY_LIMITS.ticks } = options;
    const { challengeKey: key, challengeSubject: subject, now } = options;
    if (key !== undefined && now === undefined) {
      throw new RangeError('verifyPlay: expected the present time as "now" with a challengeKey, found none');
    }
    if (key !== undefined) expectSecret(key, 'verifyPlay');
    const nothing = { found: null, ending: null, differs: null, signs: null, work: 0 };
    const decoded = decodePlay(bytes);
    if (!decoded.ok) return { ...nothing, verdict: decoded.verdict, message: decoded.message, play: null, challenge: null };
    const { play } = decoded;
    const check = key === undefined ? null : { key, subject, now: now as number };
    const challenge = challengeState(play.challenge, this.hash, check);
    const refused = (verdict: PlayVerdict, message: string): VerifiedPlay => ({ ...nothing, verdict, message, play, challenge });
    const why = whyNotReplayed(play, { hash: this.hash, accuracy, maxTicks });
    if (why !== null) return refused(why.verdict, why.message);
    if (challenge === 'missing' || challenge === 'forged' || challenge === 'expired') {
      return refused('claim-differs', CHALLENGE_IN_WORDS[challenge]);
    }
    const budget = new WorkBudget(options.maxWork ?? DEFAULT_MAX_WORK);
    try {
      const replayed = replay(this.scene(play.accuracy), play, budget);
      return { ...nothing, ...this.compare(play, replayed), play, challenge, work: budget.spent };
    } catch (error) {
      if (!(error instanceof WorkLimitReached)) throw error;
      return { ...refused('too-long', `expected a replay within the limit, found ${error.message}`), work: budget.spent };
    }
  }

  private compare(
    play: Play,
    { found, collected, hash, ending, wrong }: Replayed,
  ): Pick<VerifiedPlay, 'verdict' | 'message' | 'found' | 'ending' | 'differs' | 'signs'> {
    const { claim } = play;
    const span = (from: number, to: number) => ({
      from,
      to,
      words: `tick ${from} and ${to} (${seconds(from)} s and ${seconds(to)} s)`,
    });
    const differs = (message: string, { from, to }: PlaySpan) =>
      ({
        verdict: 'claim-differs',
        message,
        found: wrong === null ? found : null,
        ending,
        differs: { from, to },
        signs: null,
      }) as const;
    if (wrong !== null) {
      const at = span(wrong * CHECKPOINT_TICKS, (wrong + 1) * CHECKPOINT_TICKS);
      return differs(`the replay differs from the play: first between ${at.words}`, at);
    }
    const last = span(play.checkpoints.length * CHECKPOINT_TICKS, Math.max(found.tick, claim.tick));
    if (found.tick !== claim.tick || found.minerals !== claim.minerals || found.outcome !== claim.outcome) {
      return differs(`expected ${claimInWords(claim)}, as the play claims; found ${claimInWords(found, collected)}`, last);
    }
    if (hash !== play.hash) return differs(`the replay differs from the play: first between ${last.words}`, last);
    const message = claimInWords({ ...found, minerals: collected });
    return { verdict: 'ok', message, found, ending, differs: null, signs: signsOf(this.level, play) };
  }
}

/**
 * Prepares a level for verifying many plays of it.
 *
 * @param level - the level, as `readLevel` gives it
 * @param options - accuracy, limits and challenge; those of a call of `verify` win over them
 * @returns the verifier
 */
export function createVerifier(level: Level, options: VerifyOptions = {}): PlayVerifier {
  return new LevelVerifier(level, options);
}

/**
 * Repeats a play and compares what its inputs lead to with what it claims. It is synchronous and needs nothing from outside,
 * so that it runs in Node, in a browser, in a worker and at the edge of a network alike. Whatever the bytes are, it does not
 * throw, and it ends within the limits.
 *
 * @param level - the level as the server has it, from `readLevel`
 * @param bytes - the content of a `.gqr` file
 * @param options - accuracy, limits and challenge
 * @returns what the play is found to be
 * @throws {RangeError} when `challengeKey` is given without `now`, or is too short
 *
 * @example
 * ```ts
 * const { verdict, message, play } = verifyPlay(level, bytes);
 * if (verdict === 'ok') leaderboard.add(play.claim.tick);
 * else console.warn(`${verdict}: ${message}`);
 * ```
 */
export function verifyPlay(level: Level, bytes: Uint8Array, options: VerifyOptions = {}): VerifiedPlay {
  return createVerifier(level).verify(bytes, options);
}
