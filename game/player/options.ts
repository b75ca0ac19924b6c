import type { Accuracy, AccuracyName, Ending, RunEvent } from '../../engine/index.ts';
import type { Hold } from '../../schema/basics/index.ts';

/** How a play ended: as a simulation ends, or by its time limit. */
export type PlayEnding =
  | Ending
  | { readonly outcome: 'timeout'; readonly with: null; readonly time: number; readonly tick: number };

/** An event of a play, with the place where a game shows and sounds it. */
export interface PlayEvent {
  /** What happened. */
  readonly event: RunEvent;
  /** The tick in which it happened, from 0. */
  readonly tick: number;
  /** Place of the object that the event is about; hers if it is about none; after a collision the point of contact. px. */
  readonly x: number;
  /** See {@link PlayEvent.x}, px. */
  readonly y: number;
}

/** A run that is shown beside the play. */
export interface GhostSource {
  /** What to call it, such as `best` or the name of a run. */
  readonly name: string;
  /** Its holds, half-open intervals [press, release) in ticks of 1/60 s. */
  readonly holds: readonly Hold[];
}

/** What an attempt begins with. */
export interface AttemptOptions {
  /** Holds to play instead of listening to the player: half-open intervals [press, release) in ticks of 1/60 s. */
  readonly replay?: readonly Hold[] | null;
  /** The beginning of another run, which is played at once; the player takes over at `tick`. */
  readonly from?: { readonly holds: readonly Hold[]; readonly tick: number } | null;
  /** Runs that are shown beside the play. */
  readonly ghosts?: readonly GhostSource[];
}

/** Options of {@link createPlayer}. */
export interface PlayerOptions extends AttemptOptions {
  /** The accuracy; that of `gq check`, `precise`, when left out. Ignored if a scene is given, which has one. */
  readonly accuracy?: AccuracyName | Accuracy;
  /** Simulated time after which the play ends as a timeout, s; that of the scene's terms when left out, 60 if they name none. */
  readonly maxTime?: number;
  /** The longest frame that counts, ms; 100 when left out. After a longer one the game is slower for a moment. */
  readonly maxFrame?: number;
  /** Called for every event, after the ticks of a frame. It may call any method of the player. */
  readonly onEvent?: (event: PlayEvent) => void;
  /** Called once when the play has ended, after its last event. It may call any method of the player. */
  readonly onEnd?: (ending: PlayEnding) => void;
  /** Called after every tick, once `state` is that of the tick. It must not call methods that advance or restart the player. */
  readonly onTick?: () => void;
}
