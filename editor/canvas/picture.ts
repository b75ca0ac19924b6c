import type { StoreApi } from 'zustand/vanilla';
import { type Box, isJump, STATE_SIZE, TICK } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import type { Editor, Ghost, OpenLevel, Pose } from '../core/context/index.ts';
import type { ObjectKey } from '../core/document/index.ts';
import type { LiveProof } from '../core/proof/index.ts';
import type { CanvasState } from './canvas-state.ts';
import type { Theme } from './colours.ts';
import { type DrawnPart, unchanged } from './part.ts';

/** Everything that a frame shows. Parts that are the same object as in the last frame are not drawn again. */
export interface Picture {
  readonly file: LevelFile;
  /** The astronaut's collision box under the rules of the level; the same object while its size stays. */
  readonly her: Box;
  readonly proof: LiveProof;
  readonly canvas: CanvasState;
  readonly selected: readonly ObjectKey[];
  readonly hovered: ObjectKey | null;
  readonly layers: Readonly<Record<string, boolean>>;
  /** px; null: no grid */
  readonly grid: number | null;
  readonly ghosts: readonly Ghost[];
  /** What features of the page show, one for each drawn part; the same list until one of them changes. */
  readonly parts: readonly unknown[];
  readonly pose: Pose;
  readonly editing: boolean;
  /** Whether the path of the run is shown. */
  readonly showsRun: boolean;
  readonly theme: Theme;
  /** Whether the user wants reduced motion. */
  readonly calm: boolean;
}

/** What the stage shows of an open level, read once per frame. @param drawn what features of the page draw into it */
export function pictureOf(
  editor: Editor,
  level: OpenLevel,
  canvas: StoreApi<CanvasState>,
  drawn: readonly DrawnPart[],
): () => Picture {
  const { settings, session } = editor;
  const { document, selection, hovered, proof, ghosts, playtest } = level;
  const read = drawn.map((part) => part.pictureOf(editor, level));
  const parts = unchanged(
    () => read.map((picture) => picture()),
    (all) => all,
  );
  // the pose of a tick is computed once, however many frames show it
  let posed: { proof: object; tick: number; pose: Pose } | null = null;
  const pose = (): Pose => {
    const playing = playtest.getState();
    if (playing !== null) return playing.pose();
    const { tick, hoverTick } = session.getState();
    const at = hoverTick ?? tick;
    const now = proof.proof();
    if (posed === null || posed.proof !== now || posed.tick !== at) posed = { proof: now, tick: at, pose: poseAt(now, at) };
    return posed.pose;
  };
  let her = proof.proof().scene.box;
  const box = (): Box => {
    const now = proof.proof().scene.box;
    if (now.halfWidth !== her.halfWidth || now.halfHeight !== her.halfHeight) her = now;
    return her;
  };
  return () => {
    const { snapToGrid, grid } = settings.getState();
    const { dataset } = window.document.documentElement;
    return {
      file: document.file(),
      her: box(),
      proof: proof.proof(),
      canvas: canvas.getState(),
      selected: selection.keys(),
      hovered: hovered.getState(),
      layers: session.getState().layers,
      grid: snapToGrid ? grid : null,
      ghosts: ghosts.getState(),
      parts: parts(),
      pose: pose(),
      editing: session.getState().mode === 'edit',
      showsRun: session.getState().mode === 'edit' || settings.getState().runInPlay,
      theme: dataset.theme === 'light' ? 'light' : 'dark',
      calm: dataset.motion === 'less',
    };
  };
}

/** ms between two frames that differ in decorations alone: they turn and sway slowly, and each frame costs milliseconds. */
const PACE = 30;
/** The same where decorations stand still. Something is drawn all the same, as a browser may lose what a canvas shows. */
const CALM_PACE = 1000;

/**
 * Whether a frame would show anything new.
 * @param last what the last frame showed, by parts that are other objects once they change
 * @param since ms since the last frame
 */
export function isFrameDue<T extends { readonly calm: boolean }>(last: T, now: T, since: number): boolean {
  if (since < 0 || since >= (now.calm ? CALM_PACE : PACE)) return true;
  return (Object.keys(now) as (keyof T)[]).some((part) => now[part] !== last[part]);
}

/** The asteroid that the gun pulls towards: the nearest, the first one of equals; null if there is none. */
function nearestAsteroid(proof: LiveProof, x: number, y: number, moved: Float64Array | null): { x: number; y: number } | null {
  const { asteroids } = proof.level;
  let best: { x: number; y: number } | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < asteroids.length; i++) {
    const place = moved === null ? asteroids[i] : { x: moved[2 * i], y: moved[2 * i + 1] };
    const dx = place.x - x;
    const dy = place.y - y;
    const distance = dx * dx + dy * dy;
    if (distance >= least) continue;
    least = distance;
    best = place;
  }
  return best;
}

/**
 * The positions at a tick of the shown run, interpolated between ticks.
 * @param tick may be fractional; after the end of the run, the positions are those at its end
 */
export function poseAt(proof: LiveProof, tick: number): Pose {
  const { way, minerals } = proof.run;
  const { states, count, last, held } = way;
  const ended = tick >= count - 1;
  const k = Math.max(0, Math.min(count - 1, Math.floor(tick)));
  const isStraight = !ended && !isJump(states, k * STATE_SIZE, (k + 1) * STATE_SIZE, TICK);
  // An effect may move her at once: there is no position in between, so she waits for the next tick.
  const share = isStraight ? Math.max(0, tick - k) : 0;
  const between = (i: number) =>
    states[k * STATE_SIZE + i] * (1 - share) + (share > 0 ? states[(k + 1) * STATE_SIZE + i] * share : 0);
  const state = ended ? last : null;
  const x = state === null ? between(0) : state[0];
  const y = state === null ? between(1) : state[1];
  // the box turns once per tick, not in between
  const cos = state === null ? states[k * STATE_SIZE + 4] : state[4];
  const sin = state === null ? states[k * STATE_SIZE + 5] : state[5];
  const asteroids = way.asteroids.count === 0 ? null : way.asteroids.all(k);
  const aliens = way.aliens.count === 0 ? null : way.aliens.all(k);
  const collected = new Set<number>();
  for (const mineral of minerals) if (mineral.tick <= tick) collected.add(mineral.index);
  const beamTo = held[k] === 1 && !ended ? nearestAsteroid(proof, x, y, asteroids) : null;
  return { x, y, cos, sin, beamTo, aliens, asteroids, collected };
}
