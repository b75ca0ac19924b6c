import type { ComponentType, ReactNode } from 'react';
import type { Apart } from './Graphs.tsx';
import type { Scale } from './scale.ts';

/** What a feature of the page shows in the timeline. The timeline is handed the parts of all features, and knows none by name. */
export interface TimelinePart {
  /** Lanes of its own, below that of the gun. */
  readonly lanes?: ComponentType<OnTimeline>;
  /** Over everything along the run: stripes and marks. */
  readonly marks?: ComponentType<OnTimeline>;
  /** Among the buttons above. */
  readonly buttons?: ComponentType;
  /** A hook: other runs that are shown beside the one that is edited. */
  readonly useBeside?: () => Beside;
  /** What its bars and lines mean. */
  readonly legend?: { readonly bars?: readonly LegendEntry[]; readonly graphs?: readonly LegendEntry[] };
}

/** A part with the name of its feature. */
export interface NamedPart extends TimelinePart {
  readonly name: string;
}

export interface OnTimeline {
  readonly scale: Scale;
  /** px */
  readonly width: number;
  /** The last tick of the shown run. */
  readonly end: number;
}

/** Runs beside the shown one. */
export interface Beside {
  /** How long the longest lasts, ticks; 0: there is none. */
  readonly ticks: number;
  /** The distance to one of them, drawn as a graph; null: none is chosen, or it is not known. */
  readonly apart: Apart | null;
}

export type LegendEntry = readonly [sign: ReactNode, words: string];

const ALONE: Beside = { ticks: 0, apart: null };

/** All runs beside the shown one. @param parts the same list at every call */
export function useBeside(parts: readonly TimelinePart[]): Beside {
  // biome-ignore lint/correctness/useHookAtTopLevel: the list of features never changes
  const all = parts.map((part) => part.useBeside?.() ?? ALONE);
  return {
    ticks: Math.max(0, ...all.map(({ ticks }) => ticks)),
    apart: all.find(({ apart }) => apart !== null)?.apart ?? null,
  };
}
