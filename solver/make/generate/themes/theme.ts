import type { Level } from '../../../../schema/index.ts';
import type { GeneratorSpec } from '../generator-spec.ts';
import type { SymmetryKind } from '../theme-name.ts';
import type { Flight } from './flight.ts';
import type { Site } from './site.ts';

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
