import { waysApart } from '../../../check/runs/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { pathOf } from '../../core/proof/index.ts';
import { type Comparing, comparedOf, isFresh, sourceHolds, sourceKey, sourceName } from './compared.ts';

/** A compared run on the canvas. */
export interface Racer {
  readonly slot: number;
  readonly name: string;
  /** x, y in px at every tick and at the end */
  readonly points: Float32Array;
  /** cos, sin of the box's x axis there */
  readonly turns: Float32Array;
  /** When it ends, ticks with a fraction. */
  readonly end: number;
  readonly completes: boolean;
  /** Whether the level has changed since it was simulated. */
  readonly isStale: boolean;
  /** The shown run at another accuracy: the tick at which the two part by a pixel; null: they don't, or it is another run. */
  readonly parts: number | null;
}

/** The compared runs that are shown, and the moment at which. */
export interface Race {
  readonly racers: readonly Racer[];
  readonly tick: number;
}

const NOBODY: readonly Racer[] = [];

function racersOf(comparing: Comparing, level: OpenLevel): readonly Racer[] {
  const now = level.proof.proof();
  return comparing.runs.flatMap(({ source, slot }): Racer[] => {
    const trajectory = comparing.trajectories.get(sourceKey(source));
    const holds = sourceHolds(level, source);
    if (trajectory === undefined || trajectory.found === null || holds === null) return [];
    const { points, turns, end } = trajectory.found;
    const isStale = !isFresh(trajectory, now, holds);
    const isApart = source.kind === 'accuracy' && !isStale;
    const apart = isApart ? waysApart({ points: pathOf(now.run.way), events: [] }, trajectory.found) : null;
    return [
      {
        ...{ slot, name: sourceName(source), points, turns, end: 60 * end.time, completes: end.outcome === 'completed', isStale },
        parts: apart?.partings.parts ?? null,
      },
    ];
  });
}

/**
 * What the canvas shows of compared runs, read once per frame: the same list of racers until one of them changes. In a playtest,
 * runs are shown if the shown run is, too, and attempts always, as they give nothing away; both need the layer of ghosts.
 */
export function raceOf({ session, settings }: Pick<Editor, 'session' | 'settings'>, level: OpenLevel): () => Race {
  const store = comparedOf(level);
  let made: { readonly comparing: Comparing; readonly parts: readonly unknown[]; readonly racers: readonly Racer[] } | null =
    null;
  const all = (): readonly Racer[] => {
    const comparing = store.getState();
    if (comparing.runs.length === 0) return NOBODY;
    const { scene } = level.proof.proof();
    const parts = [scene, level.document.file().runs, level.attempts.store.getState()];
    if (made?.comparing !== comparing || parts.some((part, i) => part !== made?.parts[i])) {
      made = { comparing, parts, racers: racersOf(comparing, level) };
    }
    return made.racers;
  };
  let shown: { readonly from: readonly Racer[]; readonly racers: readonly Racer[] } | null = null;
  /** Those that give nothing away. */
  const attemptsAlone = (from: readonly Racer[]): readonly Racer[] => {
    if (shown?.from !== from) {
      const slots = new Set(store.getState().runs.flatMap(({ source, slot }) => (source.kind === 'attempt' ? [slot] : [])));
      shown = { from, racers: from.filter(({ slot }) => slots.has(slot)) };
    }
    return shown.racers;
  };
  const now = (): Race => {
    const { mode, layers, tick, hoverTick } = session.getState();
    const racers = all();
    if (mode === 'edit') return { racers, tick: hoverTick ?? tick };
    const played = level.playtest.getState()?.moment() ?? 0;
    if (!layers.ghosts) return { racers: NOBODY, tick: played };
    return { racers: settings.getState().runInPlay ? racers : attemptsAlone(racers), tick: played };
  };
  let last: Race = { racers: NOBODY, tick: 0 };
  return () => {
    const next = now();
    if (next.racers !== last.racers || next.tick !== last.tick) last = next;
    return last;
  };
}

/** px: a longer step may be a jump, and nothing is shown between its ends. The game's own speed limit allows no longer one. */
const MOST_STEP = 25;

/** Where a racer is at a tick, which may be fractional; after its end it stays where it ended. */
export function poseOf({ points, turns, end }: Racer, tick: number): { x: number; y: number; cos: number; sin: number } {
  const last = points.length / 2 - 1;
  const at = Math.max(0, Math.min(tick, end));
  const k = at >= end ? last : Math.min(last, Math.floor(at));
  const to = Math.min(last, k + 1);
  // the last entry stands for the end, which is less than a tick after the one before
  const length = to === last && to > k ? Math.max(1e-9, end - k) : 1;
  const [x, y, cos, sin] = [points[2 * k], points[2 * k + 1], turns[2 * k], turns[2 * k + 1]];
  const [dx, dy] = [points[2 * to] - x, points[2 * to + 1] - y];
  const share = Math.hypot(dx, dy) > MOST_STEP ? 0 : Math.min(1, (at - k) / length);
  return { x: x + share * dx, y: y + share * dy, cos, sin };
}

/** How a compared run looks: never by its colour alone. */
interface Look {
  readonly dark: string;
  readonly light: string;
  /** px of screen: strokes and gaps in turn */
  readonly dashes: readonly number[];
}

/** By slot. */
export const LOOKS: readonly Look[] = [
  { dark: '#4fd8e6', light: '#00707c', dashes: [10, 6] },
  { dark: '#ff8ad6', light: '#ad1284', dashes: [2, 5] },
  { dark: '#ffa057', light: '#9a4700', dashes: [15, 5, 2, 5] },
  { dark: '#d3dd55', light: '#5a6600', dashes: [24, 7] },
];
