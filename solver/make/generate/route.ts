import { boxOf, createSimulation } from '../../../engine/index.ts';
import { type Disc, type Hold, type Place, rulesOf } from '../../../schema/basics/index.ts';
import { countOnePress, hardnessOf } from '../../measure/difficulty/index.ts';
import type { Random } from '../../random.ts';
import { type Candidate, verifyRun } from '../../verified-run.ts';
import { type DrawnFlight, drawFlights, endsOf, flightUpTo } from './flights.ts';
import type { GeneratorSpec } from './generator-spec.ts';
import { fits, type Layout, NOVA_MARGIN } from './layout.ts';
import { toLevel } from './level-file.ts';
import { ANY, luckyGames, measureRun, sceneOf } from './scouting.ts';
import { flightOf, type Theme } from './themes/index.ts';
import { forgives, tubeOf, type Way, wayOf } from './tube.ts';

/** A layout whose black hole lies at the end of a run. */
export interface Route {
  readonly layout: Layout;
  readonly run: Candidate;
}

// Ticks after which a layout is discarded: in any case, while no run suits, and while none even ends where the black hole may lie.
const MOST_TICKS = 1_200_000;
const NONE_SUITS = 800_000;
const NONE_ENDS = 200_000;

// How many suitable runs are compared. The one whose grade is nearest to the wanted one is kept.
const ROUTES = 3;

// Places for the black hole that are tried at the end of a run.
const ENDS = 6;

const SAMPLES = 60;

// The costs of measuring a run and of shifting it, in runs, about.
const MEASURING = 200;
const FORGIVING = 100;

// Random games, which show how many find the run or another way that no nova closes.
const GAMES = 100;

// The radius of a nova that closes a way, px.
const NOVA = 16;

// By how much novae beside the run raise its grade, about.
const NARROWED = 0.8;

// The share of random play that wins in a finished level, about.
const RARE = 0.004;

// What a rank of 1 weighs, as a difference of grades.
const RANK = 0.6;

// So many ticks apart suffice to see whether many single presses win.
const STRIDE = 16;

/**
 * Draws runs in a layout without a black hole, and puts the black hole at the end of one whose own grade is close to what is wanted.
 * Runs that a single press can replace do not count, unless a nova beside the run would close the way of that press.
 */
export function* findRoute(
  layout: Layout,
  spec: GeneratorSpec,
  random: Random,
  theme: Theme | null = null,
): Generator<number, Route | null> {
  const empty = createSimulation(sceneOf(layout));
  let best: { readonly route: Route; readonly off: number } | null = null;
  let [sum, ended, passed] = [0, 0, 0];
  const most = () => (ended === 0 ? NONE_ENDS : passed === 0 ? NONE_SUITS : MOST_TICKS);
  while (sum < most() && passed < ROUTES) {
    const { flights, ticks } = drawFlights(empty, spec, random);
    // a run that is not even begun costs something as well
    let cost = ticks + 50;
    for (const flight of flights) {
      const end = endOf(flight, layout, spec, random, theme);
      if (end === null) continue;
      ended++;
      const judged = judge({ ...layout, blackHole: end }, flight.holds, spec, random, theme);
      cost += judged.ticks;
      if (judged.route === null) continue;
      passed++;
      if (best === null || judged.off < best.off) best = { route: judged.route, off: judged.off };
    }
    sum += cost;
    yield cost;
  }
  return best?.route ?? null;
}

/** Draws a place for the black hole with which a run suits the theme; null where there is none. */
function endOf(flight: DrawnFlight, layout: Layout, spec: GeneratorSpec, random: Random, theme: Theme | null): Disc | null {
  const ends = endsOf(flight, layout, spec);
  const level = theme === null ? null : toLevel(layout);
  for (let i = 0; i < ENDS && ends.length > 0; i++) {
    const [{ blackHole, at }] = ends.splice(random.below(ends.length), 1);
    if (theme === null || level === null || theme.rank(level, flightUpTo(flight, at), spec) !== null) return blackHole;
  }
  return null;
}

/** The middle of the lower half of the grades: a level easily gets a little harder than it was composed. */
const wantedGrade = ({ grade: [least, most] }: GeneratorSpec): number => (least + Math.min(most, least + 2)) / 2;

/** Whether a run suits; the lower `off`, the better. */
function judge(
  ended: Layout,
  holds: readonly Hold[],
  spec: GeneratorSpec,
  random: Random,
  theme: Theme | null,
): { readonly route: Route | null; readonly off: number; readonly ticks: number } {
  const scene = sceneOf(ended);
  const run = verifyRun(scene, holds);
  let ticks = 2 * (run?.tick ?? 500);
  const no = () => ({ route: null, off: 0, ticks });
  if (run === null || run.holds.length < holds.length || verifyRun(scene, []) !== null) return no();
  const rank = theme === null ? 0 : theme.rank(scene.level, flightOf(scene, run.holds), spec);
  if (rank === null) return no();
  const tick = run.tick;
  ticks += FORGIVING * tick;
  if (!forgives(scene, run.holds, spec.certifiedTicks, random)) return no();
  const measured = measureRun(scene, run, SAMPLES, 1);
  ticks += MEASURING * tick;
  const gradeAt = (randomShare: number): number => hardnessOf({ ...measured, randomShare });
  if (measured.p40 < spec.p40 || gradeAt(RARE) < spec.grade[0] - NARROWED) return no();
  const open = tubeOf(scene, run.holds, spec.certifiedTicks, random);
  const hasRoom = roomForNovae(ended, spec, open, NOVA);
  const isClosed = (holds: readonly Hold[]) => wayOf(scene, holds).some(hasRoom);
  const shortcuts = countOnePress(scene, ANY, tick + 1, tick + 600, STRIDE);
  ticks += shortcuts.ticks;
  if (shortcuts.count > spec.onePress * shortcuts.tried && shortcuts.example !== null && !isClosed(shortcuts.example))
    return no();
  const lucky = luckyGames(scene, GAMES, random);
  ticks += lucky.ticks;
  const left = lucky.games.filter((holds) => !isClosed(holds)).length;
  const grade = gradeAt(Math.max(RARE, left / GAMES));
  // the level is as hard as that when all others are closed, and at least as hard as if none is
  if (grade < spec.grade[0] - NARROWED || gradeAt(Math.max(RARE, lucky.games.length / GAMES)) > spec.grade[1]) return no();
  return { route: { layout: ended, run }, off: Math.abs(grade - wantedGrade(spec)) - RANK * rank, ticks };
}

// px of a cell.
const CELL = 8;

// px from a way within which a nova touches whom flies there, at least.
const BESIDE = 20;

/**
 * At which places a nova of a radius, there or a little beside, leaves ways open, to the nearest cell of a grid: a forecast for many
 * places, at less cost than trying each.
 */
function roomForNovae(layout: Layout, spec: GeneratorSpec, open: readonly Way[], radius: number): (place: Place) => boolean {
  const [columns, rows] = [Math.ceil(spec.width / CELL), Math.ceil(spec.height / CELL)];
  const isTaken = new Uint8Array(columns * rows);
  const cellOf = ({ x, y }: Place): number => Math.floor(y / CELL) * columns + Math.floor(x / CELL);
  const reach = radius + boxOf(rulesOf(layout)).halfDiagonal + spec.room - BESIDE;
  const steps = Math.ceil(reach / CELL);
  for (const cell of new Set(open.flat().map(cellOf))) {
    const [column, row] = [cell % columns, Math.floor(cell / columns)];
    for (let i = Math.max(0, row - steps); i <= Math.min(rows - 1, row + steps); i++) {
      for (let k = Math.max(0, column - steps); k <= Math.min(columns - 1, column + steps); k++) {
        const [down, right] = [(i - row) * CELL, (k - column) * CELL];
        if (down * down + right * right < reach * reach) isTaken[i * columns + k] = 1;
      }
    }
  }
  for (let cell = 0; cell < isTaken.length; cell++) {
    if (isTaken[cell] === 1) continue;
    const middle = { x: ((cell % columns) + 0.5) * CELL, y: (Math.floor(cell / columns) + 0.5) * CELL };
    if (!fits(layout, spec, { ...middle, radius }, undefined, NOVA_MARGIN)) isTaken[cell] = 1;
  }
  return ({ x, y }) => x >= 0 && y >= 0 && x < spec.width && y < spec.height && isTaken[cellOf({ x, y })] === 0;
}
