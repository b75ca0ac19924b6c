import { createStore, type StoreApi } from 'zustand/vanilla';
import type { AccuracyName } from '../../engine/index.ts';
import { PLACEABLES, type Placeable, type RuleName } from '../../schema/index.ts';

/** What a press on the canvas does: select and move, pan, or place an object of that kind. */
export type Tool = 'select' | 'hand' | Placeable;
export const TOOLS: readonly Tool[] = ['select', 'hand', ...PLACEABLES];

/** What may be drawn over the level. */
export const LAYERS = ['ranges', 'margins', 'nearMisses', 'slackFan', 'ghosts', 'heatMap'] as const;
export type Layer = (typeof LAYERS)[number];

/** How fast the timeline and the playtest go, as a share of real time. */
export const RATES = [0.25, 0.5, 1, 2] as const;
export type Rate = (typeof RATES)[number];

/** What lies over the page: a dialog, the palette. */
export type Overlay =
  | 'palette'
  | 'cheatSheet'
  | 'settings'
  | 'newLevel'
  | 'open'
  | 'share'
  | 'trash'
  | 'tour'
  | 'conflict'
  | 'kept';

/** What the person at the screen is doing. It is neither saved nor undone; the level is in the document. */
export interface Session {
  readonly mode: 'edit' | 'play';
  /** Where a playtest begins: at the start, or at the scrubbed tick of the run that is shown. */
  readonly playFrom: 'start' | 'scrubbed';
  readonly tool: Tool;
  /** Name of the run that is shown and edited; null where the level has none. */
  readonly run: string | null;
  /** The scrubbed tick of 1/60 s. May have a fraction while the timeline plays. */
  readonly tick: number;
  /** The tick under the pointer in the timeline, or null. */
  readonly hoverTick: number | null;
  /** Whether the timeline plays the run by itself. */
  readonly isPlayingBack: boolean;
  readonly rate: Rate;
  readonly accuracy: AccuracyName;
  readonly layers: Readonly<Record<Layer, boolean>>;
  readonly overlay: Overlay | null;
  /** Ids of the panels in front, one a place: of a wide screen's sides, and of a phone's (null: none). */
  readonly panels: { readonly left: string; readonly right: string; readonly phone: string | null };
  /** A rule of the level that is to get the focus as soon as it is shown; null: none. */
  readonly askedRule: RuleName | null;
  /** px on screen per px of the level, as the canvas shows it */
  readonly zoom: number;
}

export type SessionStore = StoreApi<Session>;

/** The session as it begins. */
export function createSession(accuracy: AccuracyName): SessionStore {
  return createStore<Session>(() => ({
    mode: 'edit',
    playFrom: 'start',
    tool: 'select',
    run: null,
    tick: 0,
    hoverTick: null,
    isPlayingBack: false,
    rate: 1,
    accuracy,
    layers: { ranges: true, margins: true, nearMisses: true, slackFan: true, ghosts: true, heatMap: false },
    overlay: null,
    panels: { left: 'outline', right: 'inspector', phone: 'timeline' },
    askedRule: null,
    zoom: 1,
  }));
}
