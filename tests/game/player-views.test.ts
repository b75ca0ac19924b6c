import { describe, expect, it } from 'vitest';
import { createSimulation, STATE_SIZE, simulate } from '../../engine/index.ts';
import { createPlayer, type PlayEvent, type Player } from '../../game/index.ts';
import { type Level, type LevelFile, resolveLevel } from '../../schema/index.ts';
import { shipped } from '../levels/shipped-pack.ts';

const TICK = 1000 / 60;

/** She flies to the right at 60 px/s; the black hole is far away. */
const flight = (change: Partial<LevelFile>): Level =>
  resolveLevel({
    version: 1,
    name: 'x',
    range: 1000,
    astronaut: { x: 0, y: 0, vx: 60 },
    blackHole: { x: 0, y: 600 },
    asteroids: [{ x: 0, y: 300, radius: 16 }],
    ...change,
  });

/** Plays to the end in frames of a tick, each of which shows the same part of the time between two ticks. */
function frames(player: Player, part: number, show: () => void): void {
  player.advance(part * TICK);
  while (player.ending === null) {
    player.advance(TICK);
    if (player.ending === null) show();
  }
}

/** Compares what the player shows of aliens or asteroids with a simulation beside it. @returns the farthest step of one, px */
function farthest(player: Player, part: number, what: 'readAliens' | 'readAsteroids', length: number): number {
  const simulation = createSimulation(player.scene);
  const [before, after, shown] = [0, 0, 0].map(() => new Float64Array(length));
  let far = 0;
  frames(player, part, () => {
    simulation[what](before);
    simulation.advance(1, player.held);
    simulation[what](after);
    player[what](shown);
    for (let i = 0; i < length; i++) {
      far = Math.max(far, Math.abs(after[i] - before[i]));
      const isAlive = what === 'readAliens' && i % 3 === 2;
      expect(shown[i]).toBeCloseTo(isAlive ? after[i] : before[i] + part * (after[i] - before[i]), 6);
    }
  });
  return far;
}

describe('between two ticks', () => {
  it.each([0.25, 0.75])('at %d, aliens and asteroids are shown between their places', (part) => {
    for (const accuracy of ['precise', 'arcade'] as const) {
      const { level } = shipped('watchdog');
      const replay = level.runs[0].holds;
      const chased = createPlayer(level, { accuracy, replay });
      expect(farthest(chased, part, 'readAliens', 3 * level.aliens.length)).toBeGreaterThan(0.1);
      const kicked = flight({ recoil: true, rules: { recoil: 1000 } });
      const player = createPlayer(kicked, { accuracy, replay: [[0, 600]], maxTime: 5 });
      expect(farthest(player, part, 'readAsteroids', 2)).toBeGreaterThan(0.1);
    }
  });

  it.each([0.25, 0.75])('at %d, she is at one end of a wormhole and nowhere between', (part) => {
    const { level } = shipped('short-cut');
    const player = createPlayer(level, { replay: level.runs[0].holds });
    const pose = new Float64Array(STATE_SIZE);
    let jumps = 0;
    frames(player, part, () => {
      player.readPose(pose);
      const { previous, state } = player;
      if (Math.hypot(state[0] - previous[0], state[1] - previous[1]) < 20) return;
      jumps++;
      expect([pose[0], pose[1]]).toEqual(part < 0.5 ? [previous[0], previous[1]] : [state[0], state[1]]);
    });
    expect(jumps).toBeGreaterThan(0);
  });
});

describe('an event is at the place', () => {
  /** The event of a kind, and where she and the aliens are after its tick. */
  function happened(level: Level, type: PlayEvent['event']['type']) {
    const told: PlayEvent[] = [];
    const player = createPlayer(level, { onEvent: (event) => told.push(event) });
    while (player.ending === null && told.every(({ event }) => event.type !== type)) player.advance(TICK);
    const aliens = new Float64Array(3 * level.aliens.length);
    // what is shown is a tick behind
    player.advance(TICK);
    player.readAliens(aliens);
    const found = told.find(({ event }) => event.type === type);
    return { x: found?.x ?? Number.NaN, y: found?.y ?? Number.NaN, her: player.state, aliens };
  }

  it.each<[string, Partial<LevelFile>]>([
    ['a nova', { novae: [{ x: 100, y: 25, radius: 20 }] }],
    ['a hot asteroid', { asteroids: [{ x: 100, y: 25, radius: 20, hot: true }] }],
    ['an alien', { aliens: [{ x: 100, y: 25, radius: 20 }] }],
  ])('where she touches %s', (_, change) => {
    const level = flight(change);
    const { x, y, her, aliens } = happened(level, 'collided');
    const centre = level.aliens.length > 0 ? { x: aliens[0], y: aliens[1] } : { x: 100, y: 25 };
    const toHer = Math.hypot(her[0] - centre.x, her[1] - centre.y);
    expect(toHer).toBeGreaterThan(20);
    expect(Math.hypot(x - centre.x, y - centre.y)).toBeCloseTo(20, 9);
    expect(Math.hypot(x - her[0], y - her[1])).toBeCloseTo(toHer - 20, 9);
  });

  it('in the middle between two aliens that explode', () => {
    const alien = { y: 100, radius: 20 };
    const { x, y, aliens } = happened(
      flight({
        aliens: [
          { x: 40, ...alien },
          { x: 81, ...alien },
        ],
      }),
      'explosion',
    );
    expect(Math.abs(aliens[3] - aliens[0])).toBeGreaterThan(20);
    expect(x).toBeCloseTo((aliens[0] + aliens[3]) / 2, 9);
    expect(y).toBeCloseTo((aliens[1] + aliens[4]) / 2, 9);
  });
});

it.each<[string, Partial<LevelFile>, Partial<LevelFile>]>([
  ['an alien', { aliens: [{ x: 900, y: 0, radius: 8 }] }, { aliens: [{ x: 901, y: 0, radius: 8 }] }],
  [
    'an asteroid that could move',
    { asteroids: [{ x: 0, y: 300, radius: 16 }], recoil: true },
    { asteroids: [{ x: 0, y: 301, radius: 16 }], recoil: true },
  ],
])('the hash of a play covers %s that nothing happens to', (_, one, other) => {
  const [a, b, again] = [one, other, one].map((change) => createPlayer(flight(change)));
  for (const player of [a, b, again]) player.advance(100);
  expect([a.events, a.state]).toEqual([b.events, b.state]);
  expect(a.hash).not.toBe(b.hash);
  expect(a.hash).toBe(again.hash);
});

describe('a ghost', () => {
  const { level } = shipped('firewalk');
  const replay = level.runs[0].holds;

  it('is held in the ticks of its holds', () => {
    const holds = [[3, 7] as const, [9, 10] as const];
    const player = createPlayer(level, { replay, ghosts: [{ name: 'ghost', holds }] });
    const held = [player.ghosts[0].held];
    for (let i = 0; i < 12; i++) {
      player.advance(TICK);
      held.push(player.ghosts[0].held);
    }
    // after tick t, the tick before it is shown
    expect(held.flatMap((isHeld, t) => (isHeld ? [t - 1] : []))).toEqual([3, 4, 5, 6, 9]);
  });

  it('stays where it ended while the play goes on', () => {
    const player = createPlayer(level, { replay, ghosts: [{ name: 'idle', holds: [] }] });
    const end = simulate(player.scene, []);
    const pose = new Float64Array(STATE_SIZE);
    player.advance(0.25 * TICK);
    while (player.tick < end.tick + 10) player.advance(TICK);
    const [ghost] = player.ghosts;
    expect([player.ending, ghost.ending?.outcome, ghost.held]).toEqual([null, end.outcome, false]);
    ghost.readPose(pose);
    expect([pose[0], pose[1]]).toEqual([end.final.x, end.final.y]);
  });
});
