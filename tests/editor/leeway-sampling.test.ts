import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { snapMove } from '../../editor/canvas/snapping.ts';
import { createEditedLevel, moveObjects, objectsOf, placesOf } from '../../editor/core/document/index.ts';
import { shapesOf } from '../../editor/features/leeway/leeway-picture.ts';
import {
  CELL_NUMBERS,
  cornerCompletes,
  type Leeway,
  MOST_REACH,
  type Requests,
  stateOfCode,
} from '../../editor/workers/index.ts';
import { leewayWork } from '../../editor/workers/jobs/leeway.ts';
import { latticeFor, movedLevel, Survey } from '../../editor/workers/leeway/index.ts';
import { compile, DEFAULT_TERMS, simulate } from '../../engine/index.ts';
import { type LevelFile, LIMITS, resolveLevel, withIds } from '../../schema/index.ts';
import { expectDeep, itQuick } from '../depth.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { SWING } from './swing-level.ts';

/** Runs the job for so many steps at most; the last of them is reported. */
function sampled(request: Requests['leeway'], steps = Number.POSITIVE_INFINITY): Leeway {
  let asked = 0;
  const work = leewayWork.steps(request, () => {
    asked++;
    return asked < steps ? 0 : 1000 * asked;
  });
  let known: Leeway | null = null;
  for (let i = 0; ; i++) {
    const step = work.next();
    known = step.value ?? known;
    if (step.done === true) break;
    if (known !== null && i >= steps) break;
  }
  if (known === null) throw new Error('nothing was reported');
  return known;
}

/** The question about one object of a file. */
function asked(
  file: LevelFile,
  key: string,
  more: { grid?: number | null; only?: number | null; around?: number },
): Requests['leeway'] {
  const { grid = null, only = null, around = 60 } = more;
  const found = objectsOf(file).get(key);
  if (found === undefined) throw new Error(`no object ${key}`);
  const { x, y } = placesOf(found)[only ?? 0];
  return {
    level: resolveLevel(file),
    terms: DEFAULT_TERMS,
    holds: file.runs?.[0].holds ?? [],
    objects: [{ kind: found.kind, index: found.index }],
    only,
    lead: { x, y },
    grid,
    seen: { left: x - around, top: y - around, right: x + around, bottom: y + around },
  };
}

/** Whether the run completes the level with the object moved as the editor moves it: by another way than that of the job. */
function completes(file: LevelFile, keys: readonly string[], dx: number, dy: number, only: number | null): boolean {
  const document = createEditedLevel(file);
  const result = document.change('Move', moveObjects(keys, dx, dy, only ?? undefined));
  if (!result.ok) throw new Error(result.refusal.message);
  return simulate(compile(resolveLevel(document.file())), file.runs?.[0].holds ?? []).outcome === 'completed';
}

/** Every place that the answer shows as sampled, and what it says of it. */
function placesShown({ cells, lattice }: Leeway): Map<string, { x: number; y: number; ok: boolean }> {
  const places = new Map<string, { x: number; y: number; ok: boolean }>();
  const put = (i: number, j: number, ok: boolean) => {
    const key = `${i} ${j}`;
    const known = places.get(key);
    // cells that share a corner agree about it
    if (known !== undefined) expect(known.ok, key).toBe(ok);
    places.set(key, { x: lattice.x + i * lattice.unit, y: lattice.y + j * lattice.unit, ok });
  };
  for (let o = 0; o < cells.length; o += CELL_NUMBERS) {
    const [left, top, right, bottom, code] = cells.subarray(o, o + CELL_NUMBERS);
    const state = stateOfCode(code);
    const corners = [
      [left, top],
      [right, top],
      [left, bottom],
      [right, bottom],
    ] as const;
    if (state === 'completes' || state === 'fails') {
      for (const [i, j] of corners) put(i, j, state === 'completes');
      if (right - left > 1 || bottom - top > 1) put((left + right) >> 1, (top + bottom) >> 1, state === 'completes');
    } else if (state === 'corners') for (const [k, [i, j]] of corners.entries()) put(i, j, cornerCompletes(code, k));
  }
  return places;
}

const near = (x: number, y: number, r: number) =>
  fc.record({ x: fc.integer({ min: x - r, max: x + r }), y: fc.integer({ min: y - r, max: y + r }) });
const fraction = fc.constantFrom(0, 0, 0.5, 0.1, 1 / 3);

/** A swing among objects, which some of them break. */
const swinging: fc.Arbitrary<LevelFile> = fc
  .record({
    novae: fc.array(near(680, 560, 160), { maxLength: 3 }),
    aliens: fc.array(near(700, 500, 200), { maxLength: 1 }),
    repulsors: fc.array(near(650, 650, 160), { maxLength: 1 }),
    wormholes: fc.array(fc.tuple(near(560, 560, 120), near(760, 560, 120)), { maxLength: 1 }),
    off: fraction,
    press: fc.integer({ min: 140, max: 160 }),
  })
  .map(({ novae, aliens, repulsors, wormholes, off, press }) => {
    const holds: [number, number][] = [[press, 435]];
    return withIds({
      ...SWING,
      asteroids: [{ id: 'bjzg', x: 600 + off, y: 620 - off, radius: 32 }],
      novae: novae.map((at) => ({ ...at, radius: 12 })),
      aliens,
      repulsors: repulsors.map((at) => ({ ...at, radius: 30 })),
      wormholes: wormholes.map(([a, b]) => ({ ...a, toX: b.x, toY: b.y, radius: 14 })) as never,
      runs: [{ name: 'solution', holds }],
    } as LevelFile);
  });

describe('where something may stand', () => {
  it('what is shown as sampled is what the engine finds when the editor moves the object there', () => {
    let [good, bad] = [0, 0];
    fc.assert(
      fc.property(
        swinging,
        fc.nat(),
        fc.constantFrom(null, 8, 7, 7.5),
        fc.integer({ min: 20, max: 700 }),
        fc.array(fc.nat(), { minLength: 12, maxLength: 12 }),
        (file, which, grid, steps, chosen) => {
          const keys = [...objectsOf(file).keys()];
          const key = keys[which % keys.length];
          const found = objectsOf(file).get(key);
          const only = found !== undefined && placesOf(found).length > 1 ? which % 2 : null;
          const request = asked(file, key, { grid, only, around: 40 });
          const answer = sampled(request, steps);
          expect(answer.base === 'completes').toBe(completes(file, [key], 0, 0, only));
          const places = [...placesShown(answer).values()];
          for (const pick of places.length === 0 ? [] : chosen) {
            const { x, y, ok } = places[pick % places.length];
            // as a drag with the pointer there
            const move = { x: x - request.lead.x, y: y - request.lead.y };
            const box = { left: 0, top: 0, right: 0, bottom: 0 };
            const { dx, dy } = snapMove(
              request.lead,
              move,
              { own: box, boxes: [], x: [], y: [] },
              { grid, toObjects: false, reach: 0 },
            );
            // finer places than those of the grid are reached without snapping
            const isOnGrid = grid !== null && Math.abs(dx - move.x) < 1e-9 && Math.abs(dy - move.y) < 1e-9;
            const [byX, byY] = isOnGrid ? [dx, dy] : [move.x, move.y];
            expect(completes(file, [key], byX, byY, only)).toBe(ok);
            if (ok) good++;
            else bad++;
          }
          for (const { direction, same, isEnd } of answer.reach) {
            const x = direction === 'left' ? -1 : direction === 'right' ? 1 : 0;
            const y = direction === 'up' ? -1 : direction === 'down' ? 1 : 0;
            const now = answer.base === 'completes';
            for (const by of [1, same >> 1, same]) {
              if (by > 0 && by <= same) expect(completes(file, [key], x * by, y * by, only)).toBe(now);
            }
            if (isEnd) expect(completes(file, [key], x * (same + 1), y * (same + 1), only)).toBe(!now);
          }
        },
      ),
      { numRuns: 40 },
    );
    // the test has seen both
    expectDeep(Math.min(good, bad)).toBeGreaterThan(20);
  });

  it('every px of the reach was simulated, and a px farther it ends otherwise', () => {
    const answer = sampled(asked(SWING, 'bjzg', { around: 16 }));
    expect([answer.base, answer.isReachKnown, answer.isFinished, answer.isCovered]).toEqual(['completes', true, true, true]);
    for (const { direction, same, isEnd } of answer.reach) {
      const x = direction === 'left' ? -1 : direction === 'right' ? 1 : 0;
      const y = direction === 'up' ? -1 : direction === 'down' ? 1 : 0;
      for (let by = 1; by <= same; by++)
        expect(completes(SWING, ['bjzg'], x * by, y * by, null), `${direction} ${by}`).toBe(true);
      if (same < MOST_REACH)
        expect([isEnd, completes(SWING, ['bjzg'], x * (same + 1), y * (same + 1), null)]).toEqual([true, false]);
    }
  });

  it('with a grid, every place of it in view was sampled in the end', () => {
    const request = asked(SWING, 'bjzg', { grid: 8, around: 30 });
    const answer = sampled(request);
    const places = placesShown(answer);
    const { left, top, right, bottom } = request.seen;
    const all = [...places.values()];
    for (let x = Math.ceil(left / 8) * 8; x <= right; x += 8) {
      for (let y = Math.ceil(top / 8) * 8; y <= bottom; y += 8) {
        const place = all.find((one) => one.x === x && one.y === y);
        expect(place?.ok).toBe(completes(SWING, ['bjzg'], x - 600, y - 620, null));
      }
    }
    expect([answer.every, answer.atEdges]).toEqual([8, 1]);
  });

  it('where no run completes the level, it finds where it would', () => {
    const file = { ...SWING, novae: [{ id: 'nova', x: 700, y: 560, radius: 90 }] };
    const answer = sampled(asked(file, 'nova', { around: 130 }), 1800);
    expect(answer.base).toBe('fails');
    const places = [...placesShown(answer).values()];
    expect(places.some(({ ok }) => ok)).toBe(true);
    const shortest = answer.reach.find(({ isEnd }) => isEnd);
    expect(shortest).toBeDefined();
  });

  it('moves several objects together, also the astronaut and the black hole, as the editor does', () => {
    const px = fc.oneof(fc.integer({ min: -200, max: 200 }), fc.double({ min: -50, max: 50, noNaN: true }));
    fc.assert(
      fc.property(arbitraryFile, fc.array(fc.nat(), { minLength: 1, maxLength: 5 }), px, px, (file, which, dx, dy) => {
        const all = [...objectsOf(file).values()];
        const chosen = [...new Set(which.map((i) => all[i % all.length]))];
        const moved = movedLevel(resolveLevel(file), chosen, { dx, dy }, null);
        const document = createEditedLevel(file);
        document.change(
          'Move',
          moveObjects(
            chosen.map(({ key }) => key),
            dx,
            dy,
          ),
        );
        const isFar = chosen.some((one) =>
          placesOf(one).some(({ x, y }) => Math.max(Math.abs(x + dx), Math.abs(y + dy)) > LIMITS.coordinate),
        );
        if (isFar) expect(moved).toBeNull();
        else expect(moved).toEqual(resolveLevel(document.file()));
      }),
    );
  });
});

describe('the survey', () => {
  /** Allowed inside a disc, with a slit. */
  const disc = (i: number, j: number) => (i * i + j * j <= 900 && Math.abs(i - 3) > 1 ? 'completes' : 'fails');

  itQuick('covers what it examines without gaps and overlaps, at every step', () => {
    const survey = new Survey({
      sampleAt: disc,
      sampleBy: disc,
      region: { left: -41.5, top: -33, right: 50, bottom: 47.2 },
      base: 5,
      finest: 4,
    });
    let step = 0;
    for (const _ of survey.work()) {
      if (step++ % 1499 !== 0) continue;
      const shapes = survey.cells();
      let area = 0;
      const frame = { left: 0, top: 0, right: 0, bottom: 0 };
      const seen = new Set<string>();
      for (let o = 0; o < shapes.length; o += CELL_NUMBERS) {
        const [left, top, right, bottom] = shapes.subarray(o, o + 4);
        area += (right - left) * (bottom - top);
        frame.left = Math.min(frame.left, left);
        frame.top = Math.min(frame.top, top);
        frame.right = Math.max(frame.right, right);
        frame.bottom = Math.max(frame.bottom, bottom);
        for (let i = left; i < right; i++)
          for (let j = top; j < bottom; j++) {
            expect(seen.has(`${i} ${j}`)).toBe(false);
            seen.add(`${i} ${j}`);
          }
      }
      expect(area).toBe((frame.right - frame.left) * (frame.bottom - frame.top));
      expect(frame.left <= -41.5 && frame.top <= -33 && frame.right >= 50 && frame.bottom >= 47.2).toBe(true);
    }
    expect(survey.isFinished).toBe(true);
    // the finest cells decide the edge exactly: each sampled place is what it is
    const answer = { cells: survey.cells(), lattice: { x: 0, y: 0, unit: 1, base: 5 } } as Leeway;
    for (const { x, y, ok } of placesShown(answer).values()) expect(ok).toBe(disc(x, y) === 'completes');
    const { allowed, open } = shapesOf(answer, 1000);
    expect(open).toEqual([]);
    // the slit is found although it is narrower than the cells
    expect(allowed.some(({ left, right, top, bottom }) => left < 3 && right > 3 && top < 0 && bottom > 0)).toBe(false);
  });

  it('begins near the object, and tells what is not sampled yet', () => {
    const survey = new Survey({
      sampleAt: disc,
      sampleBy: disc,
      region: { left: -400, top: -400, right: 400, bottom: 400 },
      base: 1,
      finest: 4,
    });
    const work = survey.work();
    for (let i = 0; i < 30; i++) work.next();
    expect(survey.sides().isCovered).toBe(false);
    const { allowed, open } = shapesOf({ cells: survey.cells(), lattice: latticeFor({ x: 0, y: 0 }, null) } as Leeway, 0);
    expect(allowed.length + open.length).toBeGreaterThan(100);
    const distance = ({ left, top }: { left: number; top: number }) => Math.hypot(left, top);
    const known = survey.cells();
    const sampledFar = [];
    for (let o = 0; o < known.length; o += CELL_NUMBERS)
      if (stateOfCode(known[o + 4]) !== 'unsampled') sampledFar.push(distance({ left: known[o], top: known[o + 1] }));
    expect(Math.max(...sampledFar)).toBeLessThan(200);
  });

  it('does not claim what takes too much work', () => {
    const survey = new Survey({
      sampleAt: (i) => (i > 0 ? 'unknown' : 'completes'),
      sampleBy: () => 'completes',
      region: { left: -20, top: -20, right: 20, bottom: 20 },
      base: 1,
      finest: 4,
    });
    for (const _ of survey.work());
    const { allowed } = shapesOf({ cells: survey.cells(), lattice: latticeFor({ x: 0, y: 0 }, null) } as Leeway, 1000);
    expect(allowed.every(({ right }) => right <= 0)).toBe(true);
    const stuck = new Survey({
      sampleAt: disc,
      sampleBy: () => 'unknown',
      region: { left: 0, top: 0, right: 9, bottom: 9 },
      base: 1,
      finest: 4,
    });
    for (const _ of stuck.work());
    expect([stuck.base, stuck.samples, stuck.isFinished]).toEqual(['unknown', 1, true]);
  });
});
