import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, type Scene, STATE_SIZE, simulate } from '../../engine/index.ts';
import { createPlayer, type PlayEvent, type Player } from '../../game/index.ts';
import type { Hold } from '../../schema/index.ts';
import { accuracyNames, levelsFor } from '../engine/accuracies.ts';
import { arbitraryPlayableLevel } from '../engine/arbitrary-level.ts';
import { pack, shipped } from '../levels/shipped-pack.ts';
import { propertySettings } from '../property-settings.ts';
import { real } from '../real.ts';

const { runs: FACTOR } = propertySettings(process.env);
const SECONDS = 8;

/** A frame: its length in ms, and what the player does before it. */
const frame = fc.record({
  ms: fc.oneof(
    { weight: 6, arbitrary: real(4, 34) },
    { weight: 3, arbitrary: fc.constantFrom(1000 / 60, 1000 / 144, 1000 / 30, 0) },
    { weight: 1, arbitrary: fc.constantFrom(-5, 250, 3_600_000, Number.POSITIVE_INFINITY) },
  ),
  input: fc.oneof(
    { weight: 8, arbitrary: fc.constant('') },
    { weight: 2, arbitrary: fc.constantFrom('p', 'r') },
    { weight: 1, arbitrary: fc.constantFrom('pr', 'rp', 'pp', 'rr', 'prp', 'prprprp', 'rprprprpr') },
  ),
});
const frames = fc.array(frame, { minLength: 60, maxLength: 400 });

function play(player: Player, all: readonly { ms: number; input: string }[]): void {
  for (const { ms, input } of all) {
    for (const key of input) key === 'p' ? player.press() : player.release();
    player.advance(ms);
  }
}

/** Everything that a play leaves behind. */
const record = (player: Player) => ({
  tick: player.tick,
  time: player.time,
  ending: player.ending,
  holds: player.holds,
  events: player.events.slice(),
  state: [...player.state],
  minerals: player.mineralCount,
  hash: player.hash,
  checkpoints: [...player.checkpoints],
});

/** The play again, by its holds, in frames of one tick. */
function again(scene: Scene, { tick, holds }: Pick<Player, 'tick' | 'holds'>, maxTime: number) {
  const player = createPlayer(scene, { replay: holds, maxTime });
  while (player.tick < tick && player.ending === null) player.advance(1000 / 60);
  return record(player);
}

describe.each(accuracyNames)('a play at %s', (accuracy) => {
  const level = fc.oneof(levelsFor(accuracy), arbitraryPlayableLevel, fc.constantFrom(...pack.map((entry) => entry.level)));

  it('is the same bits in frames of any length, and simulate repeats it', () => {
    fc.assert(
      fc.property(level, frames, (of, all) => {
        const scene = compile(of, accuracy);
        const player = createPlayer(scene, { maxTime: SECONDS });
        play(player, all);
        const played = record(player);
        expect(again(scene, player, SECONDS)).toEqual(played);

        const run = simulate(scene, played.holds, { maxTime: played.tick / 60 });
        expect(run.outcome).toBe(player.ending?.outcome ?? 'timeout');
        expect(run.events).toEqual(played.events);
        expect([run.final.x, run.final.y, run.final.vx, run.final.vy, run.final.cos, run.final.sin]).toEqual(played.state);
      }),
      { numRuns: 60 * FACTOR },
    );
  });

  it('goes on from a snapshot of any tick as if nothing had happened since', () => {
    fc.assert(
      fc.property(level, frames, frames, (of, all, other) => {
        const scene = compile(of, accuracy);
        const ghosts = [{ name: 'ghost', holds: [[10, 40] as const, [70, 100] as const] }];
        const plain = createPlayer(scene, { maxTime: SECONDS, ghosts });
        const player = createPlayer(scene, { maxTime: SECONDS, ghosts });
        const poses = [new Float64Array(STATE_SIZE), new Float64Array(STATE_SIZE)];
        for (const [i, one] of all.slice(0, 120).entries()) {
          play(plain, [one]);
          play(player, [one]);
          const snapshot = player.snapshot();
          if (i % 20 === 0) play(player, other.slice(0, 10));
          player.restore(snapshot);
          plain.ghosts[0].readPose(poses[0]);
          player.ghosts[0].readPose(poses[1]);
          expect(poses[1]).toEqual(poses[0]);
        }
        expect(record(player)).toEqual(record(plain));
      }),
      { numRuns: 20 * FACTOR },
    );
  });

  it('restarts from the same state', () => {
    fc.assert(
      fc.property(level, frames, frames, (of, before, all) => {
        const fresh = createPlayer(of, { accuracy, maxTime: SECONDS });
        const restarted = createPlayer(of, { accuracy, maxTime: SECONDS });
        play(restarted, before);
        const kept = record(restarted);
        const { events, checkpoints } = restarted;
        restarted.restart();
        expect({ ...kept, events: [...events], checkpoints: [...checkpoints] }).toEqual(kept);
        play(fresh, all);
        play(restarted, all);
        expect(record(restarted)).toEqual(record(fresh));
      }),
      { numRuns: 20 * FACTOR },
    );
  });

  it('says what the level shows: the shipped runs complete, with the hash of their replay', () => {
    for (const { level: of } of pack) {
      const scene = compile(of, accuracy);
      const run = simulate(scene, of.runs[0].holds);
      const player = createPlayer(scene, { replay: of.runs[0].holds });
      while (player.ending === null) player.advance(7.3);
      expect(player.ending).toMatchObject({ outcome: run.outcome, time: run.time, tick: run.tick, with: run.with });
      expect(player.events).toEqual(run.events);
      expect(player.checkpoints).toHaveLength(Math.floor((player.tick - 1) / 600));
    }
  });
});

const { level: firewalk } = shipped('firewalk');

describe('frames', () => {
  it('of no number are refused, and nothing is lost', () => {
    const player = createPlayer(firewalk);
    player.press();
    player.advance(500);
    const before = record(player);
    for (const ms of [Number.NaN, undefined, '16', null]) {
      expect(() => player.advance(ms as number)).toThrow(/^advance: expected the milliseconds since the last frame, found /);
    }
    expect(record(player)).toEqual(before);
  });

  it('count up to maxFrame: after a stall the game is slower rather than ahead', () => {
    expect(createPlayer(firewalk).advance(3_600_000)).toBe(6);
    expect(createPlayer(firewalk, { maxFrame: 250 }).advance(Number.POSITIVE_INFINITY)).toBe(15);
    const player = createPlayer(firewalk);
    expect(player.advance(-100)).toBe(0);
    // nothing is owed for it
    expect(player.advance(100)).toBe(6);
  });

  it('of a sixtieth of a second are a tick each', () => {
    const player = createPlayer(firewalk, { replay: firewalk.runs[0].holds });
    for (let i = 1; player.ending === null; i++) {
      expect(player.advance(1000 / 60)).toBe(1);
      expect(player.tick).toBe(i);
    }
    expect(player.tick).toBeGreaterThan(600);
  });

  it('show her between the states before and after the last tick, whether a frame has 0, 1 or several ticks', () => {
    fc.assert(
      fc.property(fc.array(real(0, 60), { minLength: 5, maxLength: 60 }), (lengths) => {
        const player = createPlayer(firewalk);
        const pose = new Float64Array(STATE_SIZE);
        const scene = compile(firewalk);
        const { trajectory } = simulate(scene, [], { maxTime: 6 });
        const exact = new Float64Array(STATE_SIZE);
        let shown = 0;
        for (const ms of lengths) {
          shown += ms / 1000;
          player.advance(ms);
          player.readPose(pose);
          // what is shown is a tick behind, at a time that grows by the length of each frame: nothing jitters
          const time = (player.tick - 1 + player.alpha) / 60;
          expect(time).toBeCloseTo(shown - 1 / 60, 4);
          if (player.tick === 0) continue;
          trajectory.at(time, exact);
          expect(Math.hypot(pose[0] - exact[0], pose[1] - exact[1])).toBeLessThan(0.01);
          expect(Math.hypot(pose[4], pose[5])).toBeCloseTo(1, 12);
        }
      }),
    );
  });
});

describe('the button', () => {
  it('counts at least one tick, however short the press', () => {
    const player = createPlayer(firewalk);
    player.advance(100);
    player.press();
    player.release();
    player.advance(100);
    expect(player.holds).toEqual([[6, 7]]);
  });

  it('keeps presses that come between two ticks apart, and drops those that come faster than anyone can press', () => {
    const player = createPlayer(firewalk);
    for (const key of 'prp') key === 'p' ? player.press() : player.release();
    player.advance(100);
    expect(player.holds).toEqual([
      [0, 1],
      [2, 6],
    ]);
    for (let i = 0; i < 101; i++) i % 2 === 0 ? player.release() : player.press();
    player.advance(100);
    expect(player.held).toBe(false);
    expect(player.holds.length).toBeLessThanOrEqual(3);
    for (let i = 0; i < 100; i++) i % 2 === 0 ? player.press() : player.release();
    player.advance(100);
    expect(player.held).toBe(false);
  });

  it('can be released without a press and pressed twice', () => {
    const player = createPlayer(firewalk);
    player.release();
    player.advance(50);
    player.press();
    player.press();
    player.advance(50);
    player.release();
    player.advance(50);
    expect(player.holds).toEqual([[3, 6]]);
  });

  it('held at the end of a play makes a hold that ends there', () => {
    const player = createPlayer(firewalk);
    player.press();
    while (player.ending === null) player.advance(100);
    expect(player.holds).toEqual([[0, player.tick]]);
    expect(simulate(player.scene, player.holds)).toMatchObject({ outcome: player.ending.outcome, time: player.ending.time });
  });

  it('does nothing during a replay, and works from the tick at which the player takes over', () => {
    const holds = firewalk.runs[0].holds;
    const replay = createPlayer(firewalk, { replay: holds });
    replay.press();
    while (replay.ending === null) replay.advance(100);
    expect(replay.ending.outcome).toBe('completed');
    expect(replay.holds).toEqual(holds);

    const taken = createPlayer(firewalk, { from: { holds, tick: 200 } });
    expect(taken.tick).toBe(200);
    expect(taken.held).toBe(true);
    taken.release();
    taken.advance(100);
    expect(taken.holds).toEqual([[110, 200]]);
  });
});

describe('callbacks', () => {
  it('say what happened and where', () => {
    const { level } = shipped('grand-tour');
    const told: PlayEvent[] = [];
    const endings: string[] = [];
    const player = createPlayer(level, {
      replay: level.runs[0].holds,
      onEvent: (event) => told.push(event),
      onEnd: ({ outcome }) => endings.push(outcome),
    });
    while (player.ending === null) player.advance(17);
    player.advance(17);
    expect(told.map(({ event }) => event)).toEqual(player.events);
    expect(endings).toEqual(['completed']);
    for (const { event, x, y, tick } of told) {
      expect(tick).toBe(event.type === 'completed' ? Math.floor(event.time * 60) : tick);
      if (event.type === 'mineral')
        expect({ x, y }).toEqual({ x: level.minerals[event.index].x, y: level.minerals[event.index].y });
      if (event.type === 'completed') expect({ x, y }).toEqual({ x: level.blackHole.x, y: level.blackHole.y });
      expect(Number.isFinite(x) && Number.isFinite(y)).toBe(true);
    }
  });

  it('may restart the player, and one that throws loses nothing', () => {
    const player = createPlayer(firewalk, {
      onEnd() {
        player.restart();
      },
    });
    for (let i = 0; i < 200; i++) player.advance(100);
    expect(player.ending).toBeNull();

    let angry = true;
    const types: string[] = [];
    const { level } = shipped('grand-tour');
    const told = createPlayer(level, {
      replay: level.runs[0].holds,
      onEvent({ event }) {
        types.push(event.type);
        if (angry) throw new Error('no sound');
      },
    });
    while (told.ending === null) {
      try {
        told.advance(50);
      } catch {
        angry = types.length < 3;
      }
    }
    told.advance(0);
    expect(types).toEqual(told.events.map(({ type }) => type));
  });
});

it('a player that takes over from a run is shown where it takes over, not a tick before', () => {
  const holds: Hold[] = [[110, 250]];
  const player = createPlayer(firewalk, { from: { holds, tick: 200 }, ghosts: [{ name: 'the same', holds }] });
  expect(player.tick).toBe(200);
  const pose = new Float64Array(STATE_SIZE);
  player.readPose(pose);
  expect([...pose]).toEqual([...player.state]);
  player.ghosts[0].readPose(pose);
  expect([...pose]).toEqual([...player.state]);
  player.advance(1000 / 120);
  player.readPose(pose);
  expect([...pose]).toEqual([...player.state]);
  player.advance(1000 / 120);
  expect([player.tick, [...player.previous]]).toEqual([201, [...pose]]);
});

it('a run that ends before the player takes over is shown at its end', () => {
  const player = createPlayer(firewalk, { from: { holds: [], tick: 3600 } });
  expect(player.ending).not.toBeNull();
  const pose = new Float64Array(STATE_SIZE);
  player.readPose(pose);
  expect([player.alpha, [...pose]]).toEqual([1, [...player.state]]);
});

it('a snapshot of another player is refused', () => {
  const [one, other] = [createPlayer(firewalk), createPlayer(firewalk)];
  expect(() => one.restore(other.snapshot())).toThrow('restore: expected a snapshot of this player, found another object');
});
