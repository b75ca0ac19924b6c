import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createPlaytest, createReplay, type Playtest } from '../../editor/features/play/playtest.ts';
import { compile, DEFAULT_TERMS, simulate, TICK_RATE } from '../../engine/index.ts';
import { type Hold, type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';

const FILE: LevelFile = {
  version: 1,
  name: 'Field',
  astronaut: { x: 200, y: 304, vy: 30 },
  blackHole: { x: 704, y: 304 },
  asteroids: [
    { x: 448, y: 304, radius: 16 },
    { x: 300, y: 120, radius: 24 },
  ],
  minerals: [{ x: 320, y: 330, radius: 40 }],
};
const level: Level = resolveLevel(FILE);
const scene = compile(level, 'precise');
const MS = 1000 / TICK_RATE;

/** What a person does in a playtest: frames of some length, and presses or releases between them. */
const frames = fc.array(fc.record({ ms: fc.double({ min: 0, max: 60, noNaN: true }), held: fc.boolean() }), { maxLength: 120 });

function playAll(playtest: Playtest, all: readonly { ms: number; held: boolean }[]): void {
  for (const { ms, held } of all) {
    if (held) playtest.player.press();
    else playtest.player.release();
    playtest.player.advance(ms);
  }
}

describe('a playtest', () => {
  it('has a point for every tick, and its holds repeat it bit for bit', () => {
    fc.assert(
      fc.property(frames, (all) => {
        const playtest = createPlaytest(scene, { from: null });
        playAll(playtest, all);
        const { player } = playtest;
        const points = playtest.points();
        expect(points).toHaveLength(2 * (player.tick + 1));
        expect([points[0], points[1]]).toEqual([200, 304]);
        const again = createPlaytest(scene, { from: { holds: player.holds, tick: player.tick } });
        expect(again.points()).toEqual(points);
        expect([again.player.hash, again.minerals, again.end]).toEqual([player.hash, playtest.minerals, playtest.end]);
      }),
      { numRuns: 60 },
    );
  });

  it('begins at a tick of a run, keeps the holds before it, and lets go of the gun unless the user holds it', () => {
    for (const isHeld of [false, true]) {
      const playtest = createPlaytest(scene, { from: { holds: [[5, 60]], tick: 20.4 } });
      expect([playtest.startTick, playtest.player.tick]).toEqual([20, 20]);
      if (!isHeld) playtest.player.release();
      playtest.player.advance(2 * MS);
      expect(playtest.player.holds).toEqual([[5, isHeld ? 22 : 20]]);
    }
  });

  it('counts a mineral once, says so when the user collects it, and ends as the simulation of its holds does', () => {
    const seen: string[] = [];
    const straight = compile(
      resolveLevel({ ...FILE, astronaut: { x: 200, y: 304 }, asteroids: FILE.asteroids?.slice(0, 1) }),
      'precise',
    );
    const playtest = createPlaytest(straight, {
      from: null,
      onMineral: () => seen.push('mineral'),
      onEnd: ({ end }) => seen.push(end?.outcome ?? 'none'),
    });
    playtest.player.press();
    for (let i = 0; i < 1000 && playtest.end === null; i++) playtest.player.advance(40);
    const run = simulate(straight, playtest.player.holds);
    const collected = run.events.filter(({ type }) => type === 'mineral').length;
    expect(collected).toBe(1);
    expect(playtest.minerals).toBe(1);
    expect(seen).toEqual([...Array<string>(collected).fill('mineral'), run.outcome]);
    // the gun is still held
    expect(playtest.pose().beamTo).toBeNull();
    expect(playtest.end).toMatchObject({ outcome: run.outcome, with: run.with, time: run.time, tick: run.tick });
  });

  it('lets her wait while the tab sleeps: a frame counts for at most 250 ms', () => {
    const playtest = createPlaytest(scene, { from: null });
    playtest.player.advance(60_000);
    expect(playtest.player.tick).toBe(15);
  });

  it('shows her between two ticks, and the beam to the asteroid that pulls her until the attempt ends', () => {
    const playtest = createPlaytest(scene, { from: null });
    playtest.player.advance(MS);
    expect(playtest.pose().beamTo).toBeNull();
    playtest.player.press();
    playtest.player.advance(1.5 * MS);
    const { player } = playtest;
    const pose = playtest.pose();
    expect(pose.y).toBeCloseTo((player.previous[1] + player.state[1]) / 2, 9);
    expect(pose.beamTo).toMatchObject({ x: level.asteroids[player.target ?? 0].x });
    for (let i = 0; i < 1000 && playtest.end === null; i++) playtest.player.advance(100);
    expect(playtest.end).not.toBeNull();
    expect(playtest.pose().beamTo).toBeNull();
  });
});

describe('a replay', () => {
  const holds: Hold[] = [
    [20, 70],
    [80, 90],
  ];
  const tick = 90;
  const level = resolveLevel({ ...FILE, minerals: [{ x: 200, y: 325, radius: 12 }] });
  const scene = compile(level, 'precise');
  const replay = { title: 'attempt 1', holds, accuracy: 'precise', tick, end: '', look: 'lost' } as const;

  it('has at each tick what the playtest had, whichever way it got there, and is over at its last tick', () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: -5, max: tick + 50 }), { minLength: 1, maxLength: 6 }), (ticks) => {
        const replayed = createReplay(level, DEFAULT_TERMS, replay);
        for (const to of ticks) {
          replayed.seek(to);
          const at = Math.min(tick, Math.max(0, to));
          expect(replayed.tick).toBe(at);
          expect(replayed.isOver).toBe(at === tick);
          expect([replayed.minerals, replayed.speed]).toEqual([playedTo(at).minerals, playedTo(at).speed]);
          expect(replayed.pose().collected.size).toBe(replayed.minerals);
        }
      }),
      { numRuns: 30 },
    );
    expect(playedTo(tick).minerals).toBe(1);
    const replayed = createReplay(level, DEFAULT_TERMS, replay);
    for (let i = 0; i < 1000 && !replayed.isOver; i++) replayed.advance(30);
    expect(replayed.tick).toBe(tick);
    expect(replayed.pose().beamTo).toBeNull();
    replayed.seek(0);
    expect([replayed.isOver, replayed.minerals]).toEqual([false, 0]);
    replayed.advance(3 * MS);
    expect(replayed.tick).toBe(3);
  });

  function playedTo(to: number): Playtest {
    return createPlaytest(scene, { from: { holds, tick: to } });
  }
});
