import type { Disc } from '../../../../schema/basics/index.ts';
import type { Level } from '../../../../schema/index.ts';
import type { Candidate } from '../../../verified-run.ts';
import type { GeneratorSpec, SymmetryKind } from '../generator-spec.ts';
import type { Layout } from '../layout.ts';
import { toLevel } from '../level-file.ts';
import { sceneOf } from '../scouting.ts';
import type { Way } from '../tube.ts';
import { type Flight, flightOf } from './flight.ts';
import type { Site } from './site.ts';
import type { Image } from './symmetry.ts';

/** How a theme makes levels, and how it is measured that a level is of it. */
export interface Theme {
  /** What is measured, as a part of a sentence: `turns around an asteroid`. */
  readonly measured: string;
  /** The least that a level of this theme measures. */
  least(spec: GeneratorSpec): number;
  /** The symmetry of its levels unless another one is asked for. */
  readonly symmetry: SymmetryKind;
  /** How what a level has to fulfil differs. */
  adjust(spec: GeneratorSpec): Partial<GeneratorSpec>;
  /** Lays out start, asteroids and fields. @returns false where they do not fit */
  arrange(site: Site): boolean;
  /** How well a route suits, before anything is composed around it: the higher the better, about 1; null if it does not. */
  rank(level: Level, flight: Flight, spec: GeneratorSpec): number | null;
  /** Composes novae and aliens around a route, and offers places for more novae. Minerals are there already. */
  compose(site: Site, flight: Flight): void;
  /** Measures a level with all its objects, by its main run. */
  measure(level: Level, flight: Flight): number;
}

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
