import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createStore } from 'zustand/vanilla';
import { dashesOf } from '../../editor/canvas/layers/dashes.ts';
import {
  createEditedLevel,
  deleteObjects,
  moveHold,
  moveObjects,
  setLevelProperty,
  setRadius,
} from '../../editor/core/document/index.ts';
import { tightestOf } from '../../editor/core/figures/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSession } from '../../editor/core/session/index.ts';
import { cardPosition, type Side } from '../../editor/features/onion/card-position.ts';
import type { Figures } from '../../editor/features/onion/former.ts';
import { FAILS, MEASURING, measured, type ShownSlack } from '../../editor/features/onion/former.ts';
import { changedObjects, onionPictureOf } from '../../editor/features/onion/onion-picture.ts';
import { rowsInWords, rowsOf, whyUnknown } from '../../editor/features/onion/rows.ts';
import { onionOf, STAYS, WAITS, watchOnion } from '../../editor/features/onion/watch-onion.ts';
import type { Requests } from '../../editor/workers/index.ts';
import { compile, DEFAULT_TERMS, type Run, simulate, TICK, termsOf } from '../../engine/index.ts';
import { type Hold, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { findSlack } from '../../solver/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';
import { type FakeJob, fakeDesk } from './fake-desk.ts';
import { breathe } from './stage.ts';
import { SWING } from './swing-level.ts';

const NOVA = { id: 'nova', x: 400, y: 700, radius: 16 };
const FILE: LevelFile = { ...SWING, novae: [NOVA] };

const simulated = (file: LevelFile, holds: readonly Hold[]): Run => simulate(compile(resolveLevel(file)), holds);
const slackOf = (file: LevelFile) => findSlack(compile(resolveLevel(file)), file.runs?.[0].holds ?? [], { minerals: 'any' });

/** A page at a clock that a test advances. `robustness` says what the Solver panel would show. */
function stage(file: LevelFile = FILE) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const session = createSession([{ id: 'onion', title: 'onion', isShown: true }]);
  const robustness = createStore<ShownSlack>(() => ({ phase: 'waiting', message: null, slack: null, withMinerals: false }));
  // as the watch of the robustness does, before anything else hears of the new run
  proof.store.subscribe(() => robustness.setState({ phase: 'waiting', slack: null }));
  const { desk, workers, clock } = fakeDesk();
  const level = { document, proof };
  const onion = watchOnion({ level, session, desk, robustness });
  const measure = () => robustness.setState({ phase: 'measured', slack: slackOf(document.file()) });
  return {
    clock,
    document,
    proof,
    session,
    robustness,
    jobs: workers.jobs as (FakeJob & { readonly request: Requests['slack'] })[],
    onion,
    measure,
    shown: () => onionOf(level).getState(),
    nudge: () => document.change('Nudge', moveObjects(['bjzg'], 1, 0), { gesture: 'nudge' }),
  };
}

describe('the comparison with what was before', () => {
  it('begins with the first change of a gesture, and keeps the way although the arrays of the proof are used again', () => {
    const { document, proof, shown, clock } = stage();
    const before = simulated(FILE, [[150, 435]]);
    const gesture = document.begin('Move');
    expect(shown().former).toBeNull();
    for (const dx of [4, 40, -90]) gesture.set(moveObjects(['bjzg'], dx, 0));
    const { former, phase } = shown();
    expect(phase).toBe('held');
    expect(former?.file).toBe(document.committedFile());
    expect(former?.figures.end?.time).toBe(before.time);
    expect(proof.proof().run.time).not.toBe(before.time);
    const points = former?.points ?? new Float32Array();
    const state = new Float64Array(6);
    for (let tick = 0; tick * TICK < before.time; tick += 7) {
      before.trajectory.at(tick * TICK, state);
      expect(points[2 * tick]).toBeCloseTo(state[0], 3);
      expect(points[2 * tick + 1]).toBeCloseTo(state[1], 3);
    }
    expect(points.at(-2)).toBeCloseTo(before.final.x, 3);
    gesture.cancel();
    expect(shown().former).toBeNull();
    expect(clock.now()).toBe(0);
  });

  it('stays when the gesture ends, until something is pressed or a while has passed', async () => {
    const { document, onion, shown, clock } = stage();
    const drag = () => {
      const gesture = document.begin('Move');
      gesture.set(moveObjects(['bjzg'], 3, 0));
      gesture.commit();
    };
    drag();
    expect(shown().phase).toBe('ended');
    expect(shown().former?.file.asteroids?.[0].x).toBe(600);
    onion.dismiss();
    expect(shown().former).toBeNull();
    drag();
    // that of this drag, and not of the first
    expect(shown().former?.file.asteroids?.[0].x).toBe(603);
    await clock.pass(STAYS - 1);
    expect(shown().former).not.toBeNull();
    await clock.pass(1);
    expect(shown().former).toBeNull();
  });

  it('ends with a gesture that has changed nothing, and is not shown for what no run depends on', () => {
    const { document, onion, shown } = stage();
    const gesture = document.begin('Move');
    gesture.set(moveObjects(['bjzg'], 3, 0));
    gesture.set(moveObjects(['bjzg'], 0, 0));
    gesture.commit();
    onion.released();
    expect(shown().former).toBeNull();
    document.change('Rename', setLevelProperty('name', 'Other'), { gesture: 'typed' });
    expect(shown().former).toBeNull();
  });

  it('compares a step that keys extend with its beginning', () => {
    const { document, onion, shown, nudge } = stage();
    nudge();
    nudge();
    onion.dismiss();
    expect(shown().phase).toBe('held');
    onion.released();
    expect(shown().phase).toBe('ended');
    onion.dismiss();
    expect(shown().former).toBeNull();
    nudge();
    expect(shown().former?.file.asteroids?.[0].x).toBe(600);
    document.seal();
    nudge();
    expect(shown().former?.file.asteroids?.[0].x).toBe(603);
    document.undo();
    expect(shown().former).toBeNull();
  });

  it('is asked for again by the command, for any step, until it is asked again or something changes', () => {
    const { document, proof, onion, shown, nudge } = stage();
    expect(onion.needs()).toBe('change something first');
    document.change('Delete', deleteObjects(['nova']));
    expect([shown().former, onion.needs()]).toEqual([null, null]);
    onion.toggle();
    expect([shown().phase, shown().former?.file.novae?.length]).toEqual(['asked', 1]);
    onion.dismiss();
    expect(shown().former).not.toBeNull();
    onion.toggle();
    expect(shown().former).toBeNull();
    onion.toggle();
    document.undo();
    expect(shown().former).toBeNull();
    onion.toggle();
    expect(shown().former?.file.novae).toBeUndefined();
    proof.setTerms(termsOf('arcade'));
    expect(shown().former).toBeNull();
    // another accuracy than then: the former level is played again
    onion.toggle();
    const level = resolveLevel(shown().former?.file ?? FILE);
    expect(shown().former?.figures.end?.time).toBe(simulate(compile(level, 'arcade'), [[150, 435]]).time);
    nudge();
    expect(shown().phase).toBe('held');
  });

  it('does nothing while the layer is hidden', () => {
    const { document, session, onion, shown, nudge } = stage();
    const layer = (on: boolean) => session.setState(({ layers }) => ({ layers: { ...layers, onion: on } }));
    nudge();
    layer(false);
    expect(shown().former).toBeNull();
    expect(onion.needs()).toContain('show');
    nudge();
    document.begin('Move').set(moveObjects(['bjzg'], 30, 0));
    expect(shown().former).toBeNull();
    onion.toggle();
    expect(shown().former).toBeNull();
    // shown again in the middle of a gesture: what was before it is not known
    layer(true);
    expect(shown().former).toBeNull();
    document.seal();
    nudge();
    expect(shown().former).not.toBeNull();
  });

  it('knows the slack that the panel has shown, and asks a worker for what it has not; the latest question wins', async () => {
    const { document, jobs, shown, measure, nudge } = stage();
    nudge();
    expect(shown().slack).toBe(MEASURING);
    expect(jobs.map(({ request }) => request.level.asteroids[0].x)).toEqual([600]);
    document.seal();
    nudge();
    expect(jobs.map(({ request, isCancelled }) => [request.level.asteroids[0].x, isCancelled])).toEqual([
      [600, true],
      [601, false],
    ]);
    const slack = findSlack(compile(jobs[1].request.level), [[150, 435]], jobs[1].request.goal);
    jobs[1].end({ kind: 'done', result: slack });
    await breathe();
    expect(shown().slack).toEqual(measured(slack));
    expect(shown().slackNow).toBe(MEASURING);
    measure();
    expect(shown().slackNow).toEqual(measured(slackOf(document.file())));
    document.seal();
    nudge();
    // known, as it was that of the shown run
    expect(jobs.length).toBe(2);
    const { former, slack: known } = shown();
    expect(former?.file.asteroids?.[0].x).toBe(602);
    expect(known).toEqual(measured(slackOf(former?.file ?? FILE)));
  });

  it('is said once when the change has ended and everything is known, not while it is in progress', async () => {
    const { document, jobs, onion, shown, measure, clock } = stage();
    measure();
    const gesture = document.begin('Move');
    for (let dx = 1; dx < 6; dx++) gesture.set(moveObjects(['bjzg'], dx, 0));
    measure();
    expect(shown().said).toBe('');
    gesture.set(moveObjects(['bjzg'], 7, 0));
    gesture.commit();
    onion.released();
    expect(shown().said).toBe('');
    measure();
    expect(shown().said).toMatch(/^Before and after: run completes.*time .* s, now .*least slack \d+ ticks?.*clearance/);
    expect(jobs.length).toBe(0);
    // where the slack takes too long, the rest is said
    document.begin('Move').set(moveObjects(['bjzg'], 9, 0));
    document.seal();
    expect(shown().said).toBe('');
    await clock.pass(WAITS);
    expect(shown().said).toMatch(/^Before and after: run/);
    expect(shown().said).not.toContain('slack');
  });

  it('follows holds, too', () => {
    const { document, shown } = stage();
    const gesture = document.begin('Move hold');
    gesture.set(moveHold('solution', 0, -60));
    expect(shown().former?.holds).toEqual([[150, 435]]);
    gesture.commit();
    expect(shown().phase).toBe('ended');
  });
});

const figures = (changes: Partial<Figures> = {}): Figures => ({
  end: { outcome: 'completed', with: { kind: 'blackHole', index: 0 }, time: 6.87, tick: 412 },
  range: 300,
  unknown: '',
  taken: 1,
  minerals: 3,
  closest: { kind: 'nova', index: 1, gap: 12, tick: 90 },
  ...changes,
});
const rows = (then: Partial<Figures>, now: Partial<Figures>, before = measured([]), after = measured([])) =>
  rowsOf(figures(then), figures(now), { before, now: after }).map(
    ({ label, before: was, after: is, by, difference }) => `${difference} ${label}: ${was} -> ${is}${by === '' ? '' : `, ${by}`}`,
  );

describe('the figures before and after', () => {
  it('are compared one by one', () => {
    const late = { outcome: 'completed', with: null, time: 7.02, tick: 421 } as const;
    const five = measured([
      { earlier: 2, later: 3 },
      { earlier: 9, later: 0 },
    ]);
    const nine = measured([{ earlier: 9, later: 0 }]);
    const now = { end: late, taken: 3, closest: { kind: 'alien', index: 0, gap: 9.5, tick: 80 } } as const;
    expect(rows({}, now, five, nine)).toEqual([
      'same run: completes -> completes',
      'other time: 6.87 s -> 7.02 s, +0.15 s',
      'better least slack: 5 ticks -> 9 ticks, +4',
      'worse clearance: 12 px from nova 2 -> 9.5 px from alien 1, −2.5 px',
      'better minerals: 1 of 3 -> 3 of 3, +2',
    ]);
  });

  it('of a run that breaks', () => {
    const end = { outcome: 'collided', with: { kind: 'nova', index: 1 }, time: 3, tick: 180 } as const;
    const closest = { kind: 'nova', index: 1, gap: -0.5, tick: 179 } as const;
    const slack = measured([{ earlier: 0, later: 1 }]);
    expect(rows({}, { end, closest }, slack, FAILS)).toEqual([
      'worse run: completes -> hits nova 2',
      'other time: 6.87 s -> 3.00 s, −3.87 s',
      'worse least slack: 1 tick -> none: it fails',
      'worse clearance: 12 px -> 0 px from nova 2, −12 px',
    ]);
    expect(rows({ end, closest }, { end, closest }, FAILS, FAILS).every((row) => row.startsWith('same'))).toBe(true);
  });

  it('invent nothing where something is not known', () => {
    expect(rows({}, { end: null, unknown: 'work limit' })).toEqual(['unknown run: completes -> not known']);
    expect(rows({}, {}, MEASURING, measured([]))[2]).toBe('unknown least slack: … -> no holds');
    expect(rows({}, {}, { is: 'unknown', why: 'stopped' }, FAILS)[2]).toBe('unknown least slack: not known -> none: it fails');
    // 60 or more each: how they differ is not known
    const much = measured([{ earlier: 60, later: 4 }]);
    const more = measured([{ earlier: 60, later: 9 }]);
    expect(rows({}, {}, much, more)[2]).toBe('unknown least slack: 64+ ticks -> 69+ ticks');
    expect(rows({}, {}, measured([{ earlier: 8, later: 4 }]), more)[2]).toBe('better least slack: 12 ticks -> 69+ ticks');
    expect(rows({}, {}, measured([{ earlier: 59, later: 59 }]), more)[2]).toBe('unknown least slack: 118 ticks -> 69+ ticks');
    expect(whyUnknown(figures(), figures({ end: null, unknown: 'work limit' }))).toBe('work limit');
  });

  it('leave out hazards that neither has, and tell a difference below what is shown', () => {
    expect(rows({ closest: null }, { closest: null }).length).toBe(3);
    expect(rows({ closest: null }, {})[3]).toBe('worse clearance: no hazard -> 12 px from nova 2');
    const end = { outcome: 'completed', with: null, time: 6.871, tick: 412 } as const;
    expect(rows({}, { end })[1]).toBe('other time: 6.87 s -> 6.87 s, by less than 0.01 s');
  });

  it('are one sentence', () => {
    const all = rowsOf(figures(), figures({ taken: 0 }), { before: MEASURING, now: MEASURING });
    expect(rowsInWords(all, null)).toBe(
      'Before and after: run completes, as before; time 6.87 s, as before; clearance 12 px from nova 2, as before; minerals 1 of 3, now 0 of 3, minus 1, worse.',
    );
    const same = rowsOf(figures(), figures(), { before: FAILS, now: FAILS });
    expect(rowsInWords(same, null)).toBe(
      'As before: run completes; time 6.87 s; least slack none: it fails; clearance 12 px from nova 2.',
    );
    expect(rowsInWords([], 'work limit')).toBe("Before and after can't be compared: work limit.");
  });

  it('name the press or release with the least room', () => {
    expect(tightestOf([])).toBeNull();
    const edge = fc.record({ earlier: fc.nat(60), later: fc.nat(60) });
    fc.assert(
      fc.property(fc.array(edge, { minLength: 1, maxLength: 8 }), (slack) => {
        const found = tightestOf(slack);
        const rooms = slack.map(({ earlier, later }) => earlier + later);
        expect(found?.room).toBe(Math.min(...rooms));
        expect(found?.edge).toBe(rooms.indexOf(Math.min(...rooms)));
      }),
    );
  });
});

describe('the nearest hazard', () => {
  it('is that of the least gap, and never nearer than the exact clearance', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const document = createEditedLevel({ ...file, runs: [{ name: 'one', holds: [[5, 60]] }] });
        const { margins, full } = createProofStore(document, DEFAULT_TERMS).proof();
        const { gap, closest } = margins;
        if (closest === null) {
          expect(gap.every((px) => px === Number.POSITIVE_INFINITY)).toBe(true);
          return;
        }
        expect(closest.gap).toBe(gap.reduce((least, px) => Math.min(least, px), Number.POSITIVE_INFINITY));
        expect(gap[closest.tick]).toBe(closest.gap);
        const exact = full?.clearance?.distance ?? Number.NaN;
        expect(closest.gap).toBeGreaterThanOrEqual(exact - 1e-6 * Math.max(1, Math.abs(exact)) - 1e-5);
      }),
      { numRuns: 60 },
    );
  });
});

describe('the picture of what was before', () => {
  it('outlines what moved, was resized or deleted, and nothing else', () => {
    const document = createEditedLevel(FILE);
    const before = document.file();
    document.change('Move', moveObjects(['bjzg', '@astronaut'], 8, -8));
    const { discs, start, links } = onionPictureOf(
      { file: before, points: new Float32Array(2), her: {} } as never,
      document.file(),
    );
    expect(discs).toEqual([{ x: 600, y: 620, radius: 32 }]);
    expect(start).toEqual({ x: 500, y: 760 });
    expect(links.map(({ from, to }) => [to.x - from.x, to.y - from.y])).toEqual([
      [8, -8],
      [8, -8],
    ]);
    const moved = document.file();
    document.change('Resize', setRadius(['bjzg'], 20));
    document.change('Delete', deleteObjects(['nova']));
    const changed = changedObjects(moved, document.file());
    expect(changed.map(({ key, is }) => [key, is === null])).toEqual([
      ['bjzg', false],
      ['nova', true],
    ]);
    expect(changedObjects(document.file(), document.file())).toEqual([]);
  });

  it('shows one box instead of the outlines of hundreds of objects', () => {
    const asteroids = Array.from({ length: 150 }, (_, i) => ({ id: `m${i}`, x: 100 + 10 * i, y: -500, radius: 8 }));
    const document = createEditedLevel({ ...FILE, asteroids: [...(FILE.asteroids ?? []), ...asteroids] });
    const before = document.file();
    const former = { file: before, points: new Float32Array(2), her: {} } as never;
    document.change('Move', moveObjects([...asteroids.map(({ id }) => id), '@astronaut'], 8, -8));
    const { discs, extent, start, links } = onionPictureOf(former, document.file());
    expect(discs).toEqual([]);
    expect(extent).toEqual({ left: 92, top: -508, right: 1598, bottom: -492 });
    expect(start).toEqual({ x: 500, y: 760 });
    expect(links).toHaveLength(1);
    document.undo();
    document.change(
      'Move',
      moveObjects(
        asteroids.slice(0, 100).map(({ id }) => id),
        8,
        -8,
      ),
    );
    const few = onionPictureOf(former, document.file());
    expect([few.discs.length, few.links.length, few.extent]).toEqual([100, 100, null]);
  });

  it('dashes a line: half of it is drawn, on the line, from its beginning', () => {
    const point = fc.integer({ min: -400, max: 400 });
    fc.assert(
      fc.property(fc.array(point, { minLength: 4, maxLength: 40 }), fc.integer({ min: 1, max: 50 }), (numbers, dash) => {
        const line = numbers.slice(0, 2 * Math.floor(numbers.length / 2));
        const length = (one: readonly number[]) => {
          let sum = 0;
          for (let i = 2; i < one.length; i += 2) sum += Math.hypot(one[i] - one[i - 2], one[i + 1] - one[i - 1]);
          return sum;
        };
        const whole = length(line);
        const dashes = dashesOf([line], dash);
        const drawn = dashes.reduce((sum, one) => sum + length(one), 0);
        const each = Math.max(dash, whole / 3000);
        // of each period the first half
        const periods = Math.floor(whole / (2 * each));
        const expected = periods * each + Math.min(each, whole - 2 * each * periods);
        expect(drawn).toBeCloseTo(expected, 5);
        for (const one of dashes) expect(length(one)).toBeLessThanOrEqual(each + 1e-6);
        if (whole > 0) expect(dashes[0].slice(0, 2)).toEqual(line.slice(0, 2));
      }),
    );
  });
});

describe('the place of the card', () => {
  const px = (most: number) => fc.integer({ min: 0, max: most });
  it('is on the page, beside what it belongs to wherever there is room, and where it covers least', () => {
    const page = { width: 800, height: 600 };
    const beside = fc
      .tuple(px(800), px(600), px(80))
      .map(([x, y, r]) => ({ left: x - r, top: y - r, right: x + r, bottom: y + r }));
    const card = fc.record({ width: fc.integer({ min: 40, max: 300 }), height: fc.integer({ min: 20, max: 200 }) });
    const points = fc.array(fc.record({ x: px(800), y: px(600) }), { maxLength: 20 });
    const sides = fc.constantFrom<Side | null>(null, 'right', 'left', 'below', 'above');
    fc.assert(
      fc.property(beside, card, points, sides, (rect, size, covered, last) => {
        const { x, y, side } = cardPosition(rect, size, page, () => covered, last);
        expect(x).toBeGreaterThanOrEqual(8);
        expect(y).toBeGreaterThanOrEqual(8);
        expect(x + size.width).toBeLessThanOrEqual(792);
        expect(y + size.height).toBeLessThanOrEqual(592);
        const overlaps = x < rect.right && x + size.width > rect.left && y < rect.bottom && y + size.height > rect.top;
        expect(overlaps && side !== null).toBe(false);
        // on a page of this size there is room on some side of anything so small
        expect(side).not.toBeNull();
        if (last !== null && side === last) return;
        const covers = (at: { x: number; y: number }) =>
          covered.filter((p) => p.x > at.x && p.x < at.x + size.width && p.y > at.y && p.y < at.y + size.height).length;
        for (const other of ['right', 'left', 'below', 'above'] as const) {
          const there = cardPosition(rect, size, page, () => covered, other);
          if (there.side === other && last === null) expect(covers({ x, y })).toBeLessThanOrEqual(covers(there));
        }
      }),
    );
  });

  it('is still on the page where no side has room', () => {
    const card = { width: 260, height: 120 };
    const place = cardPosition(
      { left: 100, top: 100, right: 212, bottom: 212 },
      card,
      { width: 320, height: 320 },
      () => [],
      null,
    );
    expect(place).toEqual({ side: null, x: 52, y: 192 });
  });
});
