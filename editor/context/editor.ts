import type { StoreApi } from 'zustand/vanilla';
import type { LevelFile } from '../../schema/index.ts';
import type { Attempts } from '../attempts/index.ts';
import type { Commands } from '../commands/index.ts';
import type { EditedLevel, ObjectKey, SelectionStore } from '../document/index.ts';
import type { OpenedLevel, OpeningMarks, Workspace } from '../files/index.ts';
import type { Journal } from '../journal/index.ts';
import type { Notices } from '../notices/index.ts';
import type { ProofStore } from '../proof/index.ts';
import type { SessionStore } from '../session/index.ts';
import type { SettingsStore } from '../settings/index.ts';
import type { Workers } from '../workers/index.ts';
import type { Ghost } from './ghost.ts';
import type { Pose } from './pose.ts';

/** How robust a run was found to be. It holds for these holds alone: another run, or an edit, makes it old. */
export interface Analysis {
  /** The holds it is about, joined by commas. */
  readonly holds: string;
  /** How far each press and release may move alone, ticks; two a hold. */
  readonly slack: readonly { readonly earlier: number; readonly later: number }[];
  /** All shifts of all edges by up to so many ticks succeed; null while that is being certified. */
  readonly certifiedTicks: number | null;
  /** Whether some shift by one tick more is known to fail; false where there were too many to try. */
  readonly decided: boolean;
  /** Chance of success with timing noise of 40 ms, 0 to 1. */
  readonly p40: number;
}

/** The level on the screen and what hangs on it. */
export interface OpenLevel {
  /** Its file: where it is, whether it is saved, who may write it. */
  readonly opened: OpenedLevel;
  readonly document: EditedLevel;
  readonly selection: SelectionStore;
  /** The object that is pointed at, on the canvas or in the outline. */
  readonly hovered: StoreApi<ObjectKey | null>;
  readonly proof: ProofStore;
  /** Other ways that the canvas shows: attempts, candidates, the fan of slack. */
  readonly ghosts: StoreApi<readonly Ghost[]>;
  readonly attempts: Attempts;
  /** null until it is known */
  readonly analysis: StoreApi<Analysis | null>;
  /** The playtest that is going on; the canvas shows its pose, asked once a frame. */
  readonly playtest: StoreApi<{ readonly pose: () => Pose } | null>;
}

/** Everything a part of the editor may use. One a page. */
export interface Editor {
  readonly settings: SettingsStore;
  readonly session: SessionStore;
  readonly commands: Commands;
  readonly notices: Notices;
  readonly workspace: Workspace;
  /** What is kept of levels in this browser until they are saved. */
  readonly journal: Journal;
  /** What the page before did not survive opening. */
  readonly marks: OpeningMarks;
  /** A level that came with the page's address and is not taken in yet. */
  readonly incoming: StoreApi<LevelFile | null>;
  /** Id of a level that is not opened before the person has been asked. */
  readonly heldBack: StoreApi<string | null>;
  /** Ids of levels that are to be opened without being played. */
  readonly unchecked: Set<string>;
  readonly workers: Workers;
  /** null while nothing is open */
  readonly open: StoreApi<OpenLevel | null>;
}
