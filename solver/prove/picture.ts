import { boxOf } from '../../engine/index.ts';
import { type Disc, type Level, type Place, rulesOf } from '../../schema/basics/index.ts';
import { standingCircles } from './blockers.ts';
import { followBoxes } from './boxes.ts';
import { placesIn } from './dead-end.ts';
import { mostOf } from './doomed.ts';
import { MOST_PIPES } from './flowpipe.ts';
import { followOrbits, MOST_ORBITS } from './orbits/index.ts';
import { followPipes } from './pipe.ts';
import type { Proof } from './proof.ts';
import { distance } from './rounding.ts';
import { settingOf, thingOf } from './setting.ts';

/** Side of the squares that show where an orbit may lead, px. */
const SQUARE = 8;

/**
 * The meaning of a drawn disc or line:
 * - `blocked`: her centre cannot be inside the disc
 * - `range`: she is lost outside all of these discs
 * - `thing`: her box could touch the object from inside the disc
 * - `barrier`: a closed line that she cannot cross
 * - `stretch`: a line that she cannot leave
 * - `reach`: a square through which she may come
 */
export type ProofRole = 'blocked' | 'range' | 'thing' | 'barrier' | 'stretch' | 'reach';

/** What to draw over a picture of the level to show a proof. Coordinates are px of the level. */
export interface ProofPicture {
  /** Discs to draw. */
  readonly discs: readonly (Place & {
    /** Radius, px. */
    readonly radius: number;
    /** The meaning of the disc. */
    readonly role: ProofRole;
  })[];
  /** Lines to draw. */
  readonly lines: readonly {
    /** The corners of the line. */
    readonly points: readonly Place[];
    /** Whether the last corner is joined to the first. */
    readonly closed: boolean;
    /** The meaning of the line. */
    readonly role: ProofRole;
  }[];
}

/**
 * Computes the picture of a proof.
 * @param level the level that the proof is about
 * @param proof a proof that {@link proveImpossible}, {@link proveBy} or {@link proveMineralsUnreachable} found for this level
 * @returns the discs and lines to draw
 */
export function proofPicture(level: Level, { about, certificate, covers, maxTime }: Proof): ProofPicture {
  const thing = about.kind === 'blackHole' ? level.blackHole : level.minerals[about.index];
  const box = boxOf(rulesOf(level));
  const leastHalf = Math.min(box.halfWidth, box.halfHeight);
  const touch = { x: thing.x, y: thing.y, radius: thing.radius + box.halfDiagonal, role: 'thing' as const };
  const ranges = (indices: readonly number[]) =>
    indices.map((i) => ({ x: level.asteroids[i].x, y: level.asteroids[i].y, radius: level.range, role: 'range' as const }));
  const blocked = (by: readonly { readonly kind: string; readonly index?: number }[], more: number) =>
    circlesOf(level, by).map(({ x, y, radius }) => ({ x, y, radius: radius + more, role: 'blocked' as const }));
  switch (certificate.kind) {
    case 'nothing-in-range':
      return { discs: [...ranges([...level.asteroids.keys()]), touch], lines: [] };
    case 'starts-in-hazard':
      return { discs: [...blocked([certificate.hazard], 0), touch], lines: [] };
    case 'covered': {
      const near = (c: Disc) => distance(c, thing) < touch.radius + c.radius;
      const hazards = [...level.novae, ...level.asteroids.filter(({ hot }) => hot)].filter(near);
      return { discs: [...hazards.map(({ x, y, radius }) => ({ x, y, radius, role: 'blocked' as const })), touch], lines: [] };
    }
    case 'out-of-range':
      return { discs: [...ranges(certificate.asteroids), touch], lines: [] };
    case 'enclosed': {
      const { barrier } = certificate;
      const atRange = barrier.some(({ by }) => by.kind === 'range');
      return {
        discs: [
          ...(atRange ? ranges([...level.asteroids.keys()]) : []),
          ...blocked(
            barrier.map(({ by }) => by),
            leastHalf,
          ),
          touch,
        ],
        lines: [{ points: barrier.map(({ x, y }) => ({ x, y })), closed: true, role: 'barrier' }],
      };
    }
    case 'line-trap': {
      const { back, front, target } = certificate;
      const { x, y } = level.astronaut;
      const dx = level.asteroids[target].x - x;
      const dy = level.asteroids[target].y - y;
      const d = Math.sqrt(dx * dx + dy * dy);
      const at = (s: number) => ({ x: x + (s * dx) / d, y: y + (s * dy) / d });
      const atRange = back.by.kind === 'range' || front.by.kind === 'range';
      const setting = settingOf(level, maxTime, false);
      const beyond = [back, front].flatMap(({ at: s, by }) => {
        if (by.kind !== 'dead-end') return [];
        const apex = { x: (s * dx) / d, y: (s * dy) / d };
        const ahead = { x: (Math.sign(s) * dx) / d, y: (Math.sign(s) * dy) / d };
        const places = placesIn(setting, thingOf(level, thing), standingCircles(setting, about), apex, ahead, target, by);
        return places.map((piece) => ({
          points: piece.map((p) => ({ x: x + p.x, y: y + p.y })),
          closed: true,
          role: 'reach' as const,
        }));
      });
      return {
        discs: [...(atRange ? ranges([target]) : []), ...blocked([back.by, front.by], 0), touch],
        lines: [{ points: [at(back.at), at(front.at)], closed: false, role: 'stretch' }, ...beyond],
      };
    }
    case 'orbits': {
      const { grid, steps } = certificate;
      const squares = new Map<string, readonly Place[]>();
      const places = (x0: number, x1: number, y0: number, y1: number) => {
        for (let i = Math.floor(x0 / SQUARE); i * SQUARE <= x1; i++) {
          for (let j = Math.floor(y0 / SQUARE); j * SQUARE <= y1; j++) {
            const x = level.astronaut.x + i * SQUARE;
            const y = level.astronaut.y + j * SQUARE;
            const corners = [
              { x, y },
              { x: x + SQUARE, y },
              { x: x + SQUARE, y: y + SQUARE },
              { x, y: y + SQUARE },
            ];
            squares.set(`${i} ${j}`, corners);
          }
        }
      };
      const setting = settingOf(level, maxTime, false);
      const { endedBy } = followOrbits(setting, about, thingOf(level, thing), grid, { steps, boxes: MOST_ORBITS }, { places });
      return {
        discs: [...blocked(endedBy, leastHalf), touch],
        lines: [...squares.values()].map((points) => ({ points, closed: true, role: 'reach' })),
      };
    }
    case 'doomed':
    case 'flowpipe': {
      const { axis, cell } = certificate.grid;
      const goal = thingOf(level, thing);
      const { squares, endedBy } =
        certificate.kind === 'doomed'
          ? followBoxes(
              settingOf(level, maxTime, covers.includes('arcade')),
              about,
              goal,
              certificate.grid,
              mostOf(certificate.grid),
            )
          : followPipes(settingOf(level, maxTime, false), about, goal, certificate.grid, MOST_PIPES);
      const corner = (x: number, y: number) => ({
        x: level.astronaut.x + x * axis[0] - y * axis[1],
        y: level.astronaut.y + x * axis[1] + y * axis[0],
      });
      const square = ({ x, y }: Place) => [corner(x, y), corner(x + cell, y), corner(x + cell, y + cell), corner(x, y + cell)];
      return {
        discs: [...blocked(endedBy, leastHalf), touch],
        lines: squares.map((at) => ({ points: square(at), closed: true, role: 'reach' })),
      };
    }
  }
}

/** The circles of the named objects, each once. */
function circlesOf(level: Level, things: readonly { readonly kind: string; readonly index?: number }[]): Disc[] {
  const lists: Readonly<Record<string, readonly Disc[]>> = {
    nova: level.novae,
    asteroid: level.asteroids,
    alien: level.aliens,
    blackHole: [level.blackHole],
  };
  const circles = things.flatMap(({ kind, index }) => lists[kind]?.[index ?? -1] ?? []);
  return [...new Set(circles)];
}
