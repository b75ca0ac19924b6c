import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../../schema/index.ts';
import type { Desk } from '../ask/index.ts';
import type { Attempt, AttemptKeeper, Attempts } from '../attempts/index.ts';
import type { Commands } from '../commands/index.ts';
import type { EditedLevel, ObjectKey, SelectionStore } from '../document/index.ts';
import type { OpenedLevel, OpeningMarks, Workspace } from '../files/index.ts';
import type { Journal } from '../journal/index.ts';
import type { Notices } from '../notices/index.ts';
import type { ProofStore } from '../proof/index.ts';
import type { SessionStore } from '../session/index.ts';
import type { SettingsStore } from '../settings/index.ts';
import type { TermsStore } from '../terms/index.ts';
import type { VersionKeeper } from '../versions/index.ts';

/** The robustness of a run. It is only valid for these holds. */
export interface Analysis {
  /** The holds it belongs to, joined by commas. */
  readonly holds: string;
  /** The slack of each press and release, ticks; two per hold. */
  readonly slack: readonly { readonly earlier: number; readonly later: number }[];
  /** All shifts of all edges by up to this many ticks succeed; null while this is being certified. */
  readonly certifiedTicks: number | null;
  /** Whether some shift by one tick more is known to fail; false if there were too many to check. */
  readonly decided: boolean;
  /** Success with timing noise of 40 ms, 0 to 1. */
  readonly p40: number;
}

/** The level on the screen and everything that belongs to it. */
export interface OpenLevel {
  /** Its file: its id, its saving state, the writer lock. */
  readonly opened: OpenedLevel;
  readonly document: EditedLevel;
  readonly selection: SelectionStore;
  /** The hovered object, on the canvas or in the outline. */
  readonly hovered: StoreApi<ObjectKey | null>;
  readonly proof: ProofStore;
  /** Other paths on the canvas: attempts, candidates, the slack fan. */
  readonly ghosts: StoreApi<readonly Ghost[]>;
  readonly attempts: Attempts;
  /** null until it is known */
  readonly analysis: StoreApi<Analysis | null>;
  /** The playtest in progress; the canvas reads its pose once per frame. */
  readonly playtest: StoreApi<{
    readonly pose: () => Pose;
    /** The tick of that pose, with a fraction. */
    readonly moment: () => number;
  } | null>;
}

/** Everything that a part of the editor may use. One per page. */
export interface Editor {
  readonly settings: SettingsStore;
  /** Under which terms levels are judged and shown. */
  readonly terms: TermsStore;
  readonly session: SessionStore;
  readonly commands: Commands;
  readonly notices: Notices;
  readonly workspace: Workspace;
  /** What this browser keeps of levels until they are saved. */
  readonly journal: Journal;
  /** What this browser keeps of earlier versions of levels. */
  readonly versions: VersionKeeper;
  /** What this browser keeps of attempts at levels. */
  readonly attempts: AttemptKeeper;
  /** Marks of levels whose opening made an earlier page hang. */
  readonly marks: OpeningMarks;
  /** A level from the page's address that is not added yet. */
  readonly incoming: StoreApi<LevelFile | null>;
  /** Id of a level that is opened only after the user has been asked. */
  readonly heldBack: StoreApi<string | null>;
  /** Ids of levels that are opened without being simulated. */
  readonly unchecked: Set<string>;
  /** Where questions to workers are asked. */
  readonly desk: Desk;
  /** null while no level is open */
  readonly open: StoreApi<OpenLevel | null>;
}

/** The positions of everything that moves at one moment of a run, in px. */
export interface Pose {
  readonly x: number;
  readonly y: number;
  /** The direction of the box's x axis, a unit vector. */
  readonly cos: number;
  readonly sin: number;
  /** Where the gun pulls; null while it is not held or there is no target. */
  readonly beamTo: { readonly x: number; readonly y: number } | null;
  /** x, y, alive (1 or 0) of every alien; null: as in the level */
  readonly aliens: Float64Array | null;
  /** x, y of every asteroid; null: as in the level */
  readonly asteroids: Float64Array | null;
  /** Indices of the collected minerals. */
  readonly collected: ReadonlySet<number>;
}

/** A path beside that of the run: an attempt, a candidate, a part of the slack fan, an attempt or play that is selected. */
export interface Ghost {
  readonly id: string;
  readonly label: string;
  /** x, y in px, two entries per tick */
  readonly points: Float32Array;
  readonly look: 'attempt' | 'candidate' | 'slack' | 'selected';
}

/** So many attempts are lines on the canvas. */
const SHOWN = 24;

/** The latest attempts as ghosts on the canvas. */
export function attemptGhosts(attempts: readonly Attempt[]): Ghost[] {
  return attempts
    .slice(-SHOWN)
    .map(({ number, points }) => ({ id: `attempt-${number}`, label: `attempt ${number}`, points, look: 'attempt' }));
}

/** Replaces the ghosts of one look; those of other looks stay. */
export function putGhosts(ghosts: StoreApi<readonly Ghost[]>, look: Ghost['look'], wanted: readonly Ghost[]): void {
  const now = ghosts.getState();
  const others = now.filter((ghost) => ghost.look !== look);
  if (wanted.length > 0 || others.length < now.length) ghosts.setState([...others, ...wanted], true);
}
