import { STATE_SIZE } from '../../../engine/index.ts';
import type { Ghost } from '../../core/context/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
import { accuracyNameOf, type Loss, type LostKnown, type LostMoment, type LostState } from '../../workers/index.ts';
import { type LostFindings, lossKey } from './index.ts';

/** The part of a path on which she is lost, and where it begins. */
export interface LostStretch {
  readonly at: LostMoment;
  readonly known: LostKnown;
  /** x, y in px, alternating, from the moment on. */
  readonly points: readonly number[];
  /** Whether it is of the shown run, and not of an attempt. */
  readonly isShownRun: boolean;
}

/** What the shade of lost states shows on the canvas. */
export interface LostPicture {
  readonly squares: readonly LostSquare[];
  readonly stretches: readonly LostStretch[];
}

/** ticks between two points of a stretch */
const EACH = 2;

/** The stretches of a path: from where no run was found, and from where it is proved. */
function stretchesOf(
  loss: Loss,
  isShownRun: boolean,
  pointAt: (tick: number) => readonly [number, number] | null,
): LostStretch[] {
  const { lost, proved, last } = loss;
  const stretches: LostStretch[] = [];
  for (const [at, until] of [
    [lost, proved?.tick ?? last],
    [proved, last],
  ] as const) {
    if (at === null || (at === lost && proved !== null && proved.tick <= at.tick)) continue;
    const points: number[] = [];
    for (let tick = at.tick; tick <= until; tick += EACH) points.push(...(pointAt(tick) ?? []));
    stretches.push({ at, known: at === proved ? 'proved' : 'not found', points, isShownRun });
  }
  return stretches;
}

/** An attempt of which the path is known. */
interface PathOf {
  readonly key: string;
  readonly points: Ghost['points'];
}

/** What the canvas shows of what is lost. @param attempts whose paths are shown */
export function lostPictureOf(
  { losing, losses }: Pick<LostFindings, 'losing' | 'losses'>,
  { run, terms }: Pick<LiveProof, 'run' | 'terms'>,
  attempts: readonly PathOf[],
): LostPicture {
  const own = run.outcome === 'completed' ? undefined : losses.get(lossKey(run.holds, accuracyNameOf(terms)));
  const { states, count } = run.way;
  const along = (tick: number) => (tick < count ? ([states[tick * STATE_SIZE], states[tick * STATE_SIZE + 1]] as const) : null);
  const others = attempts.flatMap(({ key, points }) => {
    const loss = losses.get(key);
    if (loss === undefined || loss.completes) return [];
    return stretchesOf(loss, false, (tick) => (2 * tick + 1 < points.length ? [points[2 * tick], points[2 * tick + 1]] : null));
  });
  return {
    squares: squaresOf(losing?.states ?? []),
    stretches: [...others, ...(own === undefined ? [] : stretchesOf(own, true, along))],
  };
}

/** Side of a square of the shade, px of the level. */
export const LOST_SQUARE = 32;

/** A square of the shade: she was seen in it, alive, in a state that is lost. */
export interface LostSquare {
  /** Its left and upper edge, px. */
  readonly x: number;
  readonly y: number;
  /** `proved` if any of its states is proved lost. */
  readonly known: LostKnown;
  /** How many lost states were seen in it. */
  readonly states: number;
}

/** The squares of a grid that have lost states in them, row by row. */
export function squaresOf(states: readonly Pick<LostState, 'x' | 'y' | 'known'>[]): LostSquare[] {
  const squares = new Map<string, { x: number; y: number; known: LostKnown; states: number }>();
  for (const { x, y, known } of states) {
    const corner = { x: Math.floor(x / LOST_SQUARE) * LOST_SQUARE, y: Math.floor(y / LOST_SQUARE) * LOST_SQUARE };
    const key = `${corner.x} ${corner.y}`;
    const square = squares.get(key) ?? { ...corner, known, states: 0 };
    square.states++;
    if (known === 'proved') square.known = known;
    squares.set(key, square);
  }
  return [...squares.values()].sort((a, b) => a.y - b.y || a.x - b.x);
}
