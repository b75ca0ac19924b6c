import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../../engine/index.ts';
import { type Hold, PLACEABLES, type Placeable, type RuleName } from '../../../schema/index.ts';
import type { EditedLevel, Gesture, Recipe } from '../document/index.ts';

/** What a press on the canvas does: select and move, pan, or place an object of a kind. */
export type Tool = 'select' | 'hand' | Placeable;
export const TOOLS: readonly Tool[] = ['select', 'hand', ...PLACEABLES];

/** Speeds of the timeline and the playtest, relative to real time. */
export const RATES = [0.25, 0.5, 1, 2] as const;
type Rate = (typeof RATES)[number];
/** How they are written. */
export const RATE_NAMES: Readonly<Record<Rate, string>> = { 0.25: '¼×', 0.5: '½×', 1: '1×', 2: '2×' };

/** What covers the page: a dialog or the palette. */
type Overlay =
  | 'palette'
  | 'cheatSheet'
  | 'settings'
  | 'newLevel'
  | 'open'
  | 'share'
  | 'publish'
  | 'trash'
  | 'history'
  | 'nameVersion'
  | 'tour'
  | 'conflict'
  | 'kept';

/** Holds that are shown as a replay over the canvas. */
export interface Replay {
  readonly title: string;
  readonly holds: readonly Hold[];
  readonly accuracy: AccuracyName;
  /** the last tick */
  readonly tick: number;
  /** How it ends, as a sentence. */
  readonly end: string;
  readonly look: 'won' | 'lost';
}

/** The transient state of the page, neither saved nor undone; the level is in the document. */
export interface Session {
  /** What fills the page: the open level, or all levels as cards. */
  readonly view: 'level' | 'pack';
  readonly mode: 'edit' | 'play';
  /** Where a playtest begins: at the start, or at the current tick of the shown run. A replay is shown instead of a playtest. */
  readonly playFrom: 'start' | 'scrubbed' | Replay;
  readonly tool: Tool;
  /** Whether a tool stays selected after it has placed an object. */
  readonly isToolLocked: boolean;
  /** The run that is shown and edited; null if the level has none. */
  readonly run: string | null;
  /** The current tick of 1/60 s; may be fractional during playback. */
  readonly tick: number;
  /** The tick under the pointer in the timeline, or null. */
  readonly hoverTick: number | null;
  /** Whether the timeline is playing the run. */
  readonly isPlayingBack: boolean;
  readonly rate: Rate;
  /** Whether each layer is shown, by its id; a layer that no part of the page has is never shown. */
  readonly layers: Readonly<Record<string, boolean>>;
  readonly overlay: Overlay | null;
  /** The ids of the panels in front: on the sides of a wide screen, and on a phone (null: none). */
  readonly panels: { readonly left: string; readonly right: string; readonly phone: string | null };
  /** The row of the outline whose name is being edited: the key of an object, or that of a group's row; null: none. */
  readonly renaming: string | null;
  /** The note whose text is being edited: an existing one, or a new one at a place, px; null: none. */
  readonly openNote: string | { readonly x: number; readonly y: number } | null;
  /** A rule to focus as soon as it is shown; null: none. */
  readonly askedRule: RuleName | null;
  /** A point of the level to bring into view as soon as the canvas is shown; null: none. */
  readonly lookAt: { readonly x: number; readonly y: number } | null;
  /** px of screen per px of the level on the canvas */
  readonly zoom: number;
}

export type SessionStore = StoreApi<Session>;

/** The initial session. @param layers those of the canvas and of features of the page */
export function createSession(layers: readonly LayerSwitch[]): SessionStore {
  return createStore<Session>(() => ({
    view: 'level',
    mode: 'edit',
    playFrom: 'start',
    tool: 'select',
    isToolLocked: false,
    run: null,
    tick: 0,
    hoverTick: null,
    isPlayingBack: false,
    rate: 1,
    layers: Object.fromEntries(layers.map(({ id, isShown }) => [id, isShown])),
    overlay: null,
    panels: { left: 'outline', right: 'inspector', phone: 'timeline' },
    renaming: null,
    openNote: null,
    askedRule: null,
    lookAt: null,
    zoom: 1,
  }));
}

/** Shows or hides a layer. */
export const showLayer = (session: SessionStore, id: string, isShown: boolean): void =>
  session.setState(({ layers }) => ({ layers: { ...layers, [id]: isShown } }));

/** Chooses a tool. Tools that place nothing end the lock. */
export function chooseTool(session: SessionStore, tool: Tool): void {
  const places = tool !== 'select' && tool !== 'hand';
  session.setState({ tool, isToolLocked: places && session.getState().isToolLocked });
}

/** A layer over the level that can be shown and hidden. */
export interface LayerSwitch {
  /** Its name in `layers` of the session. */
  readonly id: string;
  /** In words, to follow `Show or hide the`. */
  readonly title: string;
  readonly keys?: readonly string[];
  /** Whether it is shown at first. */
  readonly isShown: boolean;
}

/** The layers of the canvas itself; features of the page add theirs. */
export const CANVAS_LAYERS: readonly LayerSwitch[] = [
  { id: 'ranges', title: 'range of the gun', isShown: true },
  { id: 'margins', title: 'hazard margins', isShown: true },
  { id: 'nearMisses', title: 'near misses', isShown: true },
  { id: 'slackFan', title: 'slack fan', isShown: true },
  { id: 'ghosts', title: 'ghosts of attempts and candidates', isShown: true },
  { id: 'notes', title: 'notes', isShown: true },
];

/** An offered change that the page shows as if it were taken: a change in progress, as while an object is dragged. */
interface Preview {
  isShown(): boolean;
  /**
   * Shows a change in place of one that is shown.
   * @param label of the step, once it is taken
   * @param run the run that shows what it does
   */
  show(label: string, recipe: Recipe, run: string): void;
  /** Keeps what is shown, as one step of the history. */
  take(): void;
  /** Shows the level and the run as they were. */
  back(): void;
  /** A step of the history has ended it: it was taken, or another change took it along. */
  ended(): void;
}

export function createPreview(document: Pick<EditedLevel, 'begin'>, session: SessionStore): Preview {
  let gesture: Gesture | null = null;
  let shownBefore: string | null = null;
  const back = () => {
    if (gesture === null) return;
    // it still counts as shown while the page follows
    gesture.cancel();
    gesture = null;
    session.setState({ run: shownBefore });
  };
  return {
    isShown: () => gesture !== null,
    show(label, recipe, run) {
      back();
      shownBefore = session.getState().run;
      gesture = document.begin(label);
      gesture.set(recipe);
      session.setState({ run });
    },
    take: () => gesture?.commit(),
    back,
    ended() {
      gesture = null;
    },
  };
}
