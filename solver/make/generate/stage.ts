import type { Disc } from '../../../schema/basics/index.ts';
import type { Candidate } from '../../verified-run.ts';
import type { Layout } from './layout.ts';
import { toLevel } from './level-file.ts';
import { sceneOf } from './scouting.ts';
import { flightOf, type Image, type Theme } from './themes/index.ts';
import type { Way } from './tube.ts';

/** What a theme asks of a level while it is made harder. */
export interface Stage {
  readonly theme: Theme | null;
  /** The least that the theme measures. */
  readonly least: number;
  /** Places that continue the composition, for more novae; without any, novae go wherever they help. */
  readonly slots: readonly Disc[];
  /** The novae that the theme has composed. */
  readonly figures: readonly Disc[];
  /** Novae and aliens that stay although they may be idle: those around a mineral that the detour collects. */
  readonly kept: readonly Disc[];
  /** Where the counterpart of a nova belongs; null for no symmetry. */
  readonly image: Image | null;
  /** A run that collects all minerals, which lead elsewhere than the solution; null: minerals are placed in the end. */
  readonly detour: Candidate | null;
  /** The ways of that run, which stay open. */
  readonly detourWays: readonly Way[];
}

/** A level without a theme. */
export const PLAIN_STAGE: Stage = {
  theme: null,
  least: 0,
  slots: [],
  figures: [],
  kept: [],
  image: null,
  detour: null,
  detourWays: [],
};

/** Whether a run is of the theme. */
export function isOnTheme({ theme, least }: Stage, layout: Layout, run: Candidate): boolean {
  return theme === null || theme.measure(toLevel(layout), flightOf(sceneOf(layout), run.holds)) >= least;
}
