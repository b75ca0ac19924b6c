import { describe, expect, it } from 'vitest';
import { compile, createSimulation, EXPLOSION_FRAMES, type Simulation, STATE_SIZE, simulate } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { type PlainLevel, plainLevel } from './plain-level.ts';

const start = (level: PlainLevel): Simulation => createSimulation(compile(plainLevel(level), 'arcade'));
const play = (level: PlainLevel, holds: [number, number][] = [], seconds = 1) =>
  simulate(compile(plainLevel(level), 'arcade'), holds, { maxTime: seconds });

function stateOf(simulation: Simulation) {
  const s = new Float64Array(STATE_SIZE);
  simulation.readState(s);
  return { x: s[0], y: s[1], vx: s[2], vy: s[3], cos: s[4], sin: s[5] };
}

function asteroidsOf(simulation: Simulation): number[] {
  const out = new Float64Array(2 * simulation.scene.level.asteroids.length);
  simulation.readAsteroids(out);
  return [...out];
}

function aliensOf(simulation: Simulation): number[] {
  const out = new Float64Array(3 * simulation.scene.level.aliens.length);
  simulation.readAliens(out);
  return [...out];
}

describe('bugs of the original that arcade keeps', () => {
  it('an asteroid no longer the nearest keeps its recoil acceleration while the gun is held, until it is nearest again', () => {
    // she flies from the first to the second; both are beside her line, so that she passes through neither
    const simulation = start({
      astronaut: { vx: 300 },
      asteroids: [
        { x: 0, y: 200, radius: 16 },
        { x: 300, y: 200, radius: 16 },
      ],
      recoil: true,
    });
    simulation.advance(45, true);
    const speed = () => {
      const before = asteroidsOf(simulation);
      simulation.advance(1, true);
      return asteroidsOf(simulation).map((v, i) => (v - before[i]) * 60);
    };
    const first = speed();
    simulation.advance(30, true);
    const later = speed();
    expect(stateOf(simulation).x).toBeGreaterThan(200);
    // the first is not the target any more but still accelerates, by 1 / 32 px/s2 for half a second
    expect(Math.hypot(later[0] - first[0], later[1] - first[1])).toBeGreaterThan(0.9 * (1 / 32) * (31 / 60));
  });

  it('several minerals touched in one frame: all count, the last disappears, the others count again', () => {
    const run = play({ minerals: [1, 2, 3].map((x) => ({ x, y: 0, radius: 7 })) });
    expect(run.minerals.map(({ index, time }) => [index, Math.round(time * 60)])).toEqual([
      [0, 0],
      [1, 0],
      [2, 0],
      [0, 1],
      [1, 1],
      [0, 2],
    ]);
  });

  it('an exploded alien continues to chase and kill, then stays where it is', () => {
    const level: PlainLevel = {
      astronaut: { x: 0, y: 0 },
      aliens: [
        { x: 120, y: 10, radius: 25 },
        { x: 120, y: -10, radius: 25 },
      ],
    };
    const simulation = start(level);
    simulation.advance(1, false);
    expect(aliensOf(simulation)).toEqual([120, 10, 0, 120, -10, 0]);
    simulation.advance(EXPLOSION_FRAMES - 1, false);
    const chased = aliensOf(simulation);
    expect(chased[0]).toBeLessThan(110);
    simulation.advance(2, false);
    const stopped = aliensOf(simulation);
    simulation.advance(100, false);
    expect(aliensOf(simulation)).toEqual(stopped);

    // and it still kills: she flies into its remains
    const run = play({ ...level, astronaut: { x: 0, y: 0, vx: 20 } }, [], 10);
    expect(run).toMatchObject({ outcome: 'collided', with: { kind: 'alien', index: 0 } });
    expect(run.tick).toBeGreaterThan(EXPLOSION_FRAMES);
  });

  it('burning sets her velocity to 0, completing does not', () => {
    const burned = play({ astronaut: { vx: 60 }, novae: [{ x: 60, y: 0, radius: 16 }] }, [], 5);
    expect(burned).toMatchObject({ outcome: 'collided', with: { kind: 'nova', index: 0 }, final: { vx: 0, vy: 0 } });
    const completed = play({ astronaut: { vx: 60 }, blackHole: { x: 60, y: 0, radius: 16 } }, [], 5);
    expect(completed).toMatchObject({ outcome: 'completed', with: { kind: 'blackHole' }, final: { vx: 60 } });
    // the displacement of the frame still happens
    expect(burned.final.x).toBe(completed.final.x);
  });
});

describe('order within a frame of arcade', () => {
  const hole = { x: 0, y: 0, radius: 18 };
  const here = { x: 0, y: 0, radius: 16 };

  it('lost before completed before burned; novae before hot asteroids before aliens', () => {
    const far = [{ x: 500, y: 0, radius: 16 }];
    expect(play({ blackHole: hole, novae: [here], asteroids: far, range: 250 }).outcome).toBe('lost');
    expect(play({ blackHole: hole, novae: [here] }).outcome).toBe('completed');
    const hot = [{ ...here, hot: true }];
    expect(play({ novae: [here], asteroids: hot, aliens: [here] }).with).toEqual({ kind: 'nova', index: 0 });
    expect(play({ asteroids: hot, aliens: [here] }).with).toEqual({ kind: 'asteroid', index: 0 });
    expect(play({ aliens: [here] }).with).toEqual({ kind: 'alien', index: 0 });
  });

  it('the checks use the positions of the previous frame', () => {
    // 10 px from her side to the rim, 60 px/s: her box enters it in the 11th displacement, so frame 11 is the first to see it
    expect(play({ astronaut: { vx: 60 }, blackHole: { x: 36.5, y: 0, radius: 16 } }).tick).toBe(11);
  });

  it('a mineral touched in the last frame counts', () => {
    expect(play({ novae: [{ x: 0, y: 0, radius: 16 }], minerals: [here] }).minerals).toHaveLength(1);
    expect(play({ aliens: [here], minerals: [here] }).minerals).toHaveLength(1);
  });
});

describe('boundaries', () => {
  it('exactly at the range she is not lost, beyond it she is', () => {
    const asteroids = [{ x: 300, y: 400, radius: 16 }];
    expect(play({ asteroids, range: 500 }).outcome).toBe('timeout');
    expect(play({ asteroids, range: 500 - 2 ** -40 })).toMatchObject({ outcome: 'lost', tick: 0, with: null });
    expect(play({ asteroids: [] }).outcome).toBe('lost');
  });

  it('an alien at exactly 150 px sleeps, nearer it wakes; out of sight it stops at once', () => {
    const wakes = (x: number) => {
      const simulation = start({ aliens: [{ x, y: 0, radius: 25 }] });
      simulation.advance(60, false);
      return aliensOf(simulation)[0] < x;
    };
    expect(wakes(DEFAULT_RULES.alienSight)).toBe(false);
    expect(wakes(DEFAULT_RULES.alienSight - 2 ** -40)).toBe(true);

    const simulation = start({ astronaut: { vx: -60 }, aliens: [{ x: 140, y: 0, radius: 25 }] });
    simulation.advance(30, false);
    const [x] = aliensOf(simulation);
    expect(x).toBeLessThan(140);
    simulation.advance(30, false);
    expect(aliensOf(simulation)[0]).toBe(x);
  });

  it('touching a nova, a field or another alien from outside is no contact', () => {
    expect(play({ novae: [{ x: 26, y: 0, radius: 16 }] }).outcome).toBe('timeout');
    expect(play({ novae: [{ x: 26 - 2 ** -40, y: 0, radius: 16 }] }).outcome).toBe('collided');
    const inField = (x: number) => play({ repulsors: [{ x, y: 0, radius: 32 }] }).final.vx !== 0;
    expect([inField(32), inField(32 - 2 ** -40)]).toEqual([false, true]);
    const explode = (y: number) =>
      play({ aliens: [400, 400].map((x, i) => ({ x, y: i * y, radius: 25 })) }).events.some((e) => e.type === 'explosion');
    expect([explode(50), explode(50 - 2 ** -40)]).toEqual([false, true]);
  });

  it('at distance 0 the gun turns her to angle 0 and pulls that way', () => {
    const simulation = start({ asteroids: [{ x: 0, y: 0, radius: 16 }], range: 250 });
    simulation.advance(2, true);
    expect(stateOf(simulation)).toMatchObject({ vy: 0, cos: 1, sin: 0 });
    expect(stateOf(simulation).vx).toBeGreaterThan(0);
  });
});

describe('the target and the active field', () => {
  const targetOf = (asteroids: PlainLevel['asteroids']) => {
    const found = play({ asteroids }, [[0, 1]]).events.find((e) => e.type === 'target');
    return found?.type === 'target' ? found.index : null;
  };

  it('the nearest asteroid is the target; on a tie the first cold one, then the first hot one', () => {
    const at = (x: number, hot = false) => ({ x, y: 0, radius: 16, hot });
    expect(targetOf([at(200), at(-100), at(150)])).toBe(1);
    expect(targetOf([at(100), at(-100)])).toBe(0);
    expect(targetOf([at(100, true), at(-100)])).toBe(1);
    expect(targetOf([at(100, true), at(-100, true)])).toBe(0);
  });

  it('the first field in the list acts instead of the gun, with the gun on or off', () => {
    const repulsors = [
      { x: -10, y: 0, radius: 48 },
      { x: 10, y: 0, radius: 48 },
    ];
    const asteroids = [{ x: 0, y: 100, radius: 16 }];
    for (const held of [true, false]) {
      const simulation = start({ repulsors, asteroids, range: 250 });
      simulation.advance(2, held);
      expect(stateOf(simulation).vx).toBeCloseTo(20 / 60, 12);
      expect(stateOf(simulation).vy).toBe(0);
      // with the gun held she still turns to the target
      expect(stateOf(simulation).sin).toBe(held ? 1 : 0);
    }
    const other = start({ repulsors: [...repulsors].reverse(), asteroids, range: 250 });
    other.advance(2, false);
    expect(stateOf(other).vx).toBeCloseTo(-20 / 60, 12);
  });

  it('recoil moves the target by 1 / diameter px/s2, keeps its speed after release, and nothing without recoil', () => {
    const level = { asteroids: [{ x: 0, y: 200, radius: 16 }], range: 250 };
    const simulation = start({ ...level, recoil: true });
    simulation.advance(31, true);
    const held = asteroidsOf(simulation)[1];
    // v after n frames: a (n - 1) dt; y: a dt^2 n (n - 1) / 2
    expect(200 - held).toBeCloseTo(((1 / 32) * (31 * 30)) / 2 / 3600, 9);
    simulation.advance(60, false);
    expect(held - asteroidsOf(simulation)[1]).toBeCloseTo((1 / 32) * (31 / 60), 6);
    const still = start(level);
    still.advance(60, true);
    expect(asteroidsOf(still)).toEqual([0, 200]);
  });
});
