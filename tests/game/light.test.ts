import { describe, expect, test } from 'vitest';
import { EFFECTS } from '../../engine/index.ts';
import { createPlayer, type Player, readLevel } from '../../game/index.ts';
import {
  aliens,
  composePlayer,
  type GamePart,
  manyObjects,
  readLevel as readHere,
  recoil,
  repulsors,
  winds,
  wormholes,
} from '../../game/light/index.ts';
import { type Hold, type Level, LISTED_KINDS, listOf, NO_OBJECTS } from '../../schema/index.ts';
import { hashedRuns } from '../browsers/scenes.ts';
import { pack } from '../levels/shipped-pack.ts';

const PARTS: readonly GamePart[] = [wormholes, winds, recoil, repulsors, aliens];

/** The parts that a level calls for. */
const partsFor = (level: Level): GamePart[] =>
  PARTS.filter(({ name, lists }) => (name === 'recoil' ? level.recoil : lists.some((list) => level[list].length > 0)));

const EMPTY: Level = {
  name: 'empty',
  description: '',
  astronaut: { x: 0, y: 0, vx: 0, vy: 0 },
  blackHole: { x: 0, y: 200, radius: 18 },
  range: 250,
  recoil: false,
  ...NO_OBJECTS,
  asteroids: [{ id: null, x: 0, y: 100, radius: 16, hot: false }],
  runs: [],
};

/** The hashes of a play, and what happened in it. */
function played(player: Player): unknown {
  while (player.ending === null) player.advance(100);
  const { hash, checkpoints, ending, events, holds } = player;
  return { hash, checkpoints, ending, events, holds };
}

describe('a player of some parts plays as the complete one, bit for bit', () => {
  test.each(pack)('$slug, with the parts that it calls for and with all', ({ level }) => {
    for (const { holds: replay } of [...level.runs, { holds: [] as Hold[] }]) {
      const whole = played(createPlayer(level, { replay }));
      expect(played(composePlayer(partsFor(level))(level, { replay }))).toEqual(whole);
      expect(played(composePlayer(PARTS)(level, { replay }))).toEqual(whole);
    }
  });

  test('crowded scenes of every part, and the hard cases', () => {
    let runs = 0;
    for (const { name, level, holds: replay } of hashedRuns()) {
      if (name.includes('.level.json')) continue;
      runs++;
      const options = { replay, maxTime: 20 };
      const parts = [...PARTS, manyObjects];
      expect([name, played(composePlayer(parts)(level, options))]).toEqual([name, played(createPlayer(level, options))]);
    }
    expect(runs).toBeGreaterThan(20);
  });

  test('30 aliens that chase her at once, without an index and with one', () => {
    const chased: Level = {
      ...EMPTY,
      aliens: Array.from({ length: 30 }, (_, i) => ({
        id: null,
        x: 40 * (i % 6) - 100,
        y: -60 - 40 * Math.floor(i / 6),
        radius: 4,
      })),
    };
    const options = { replay: [[20, 90]] as Hold[], maxTime: 10 };
    const whole = played(createPlayer(chased, options));
    expect(whole).toMatchObject({ events: expect.arrayContaining([expect.objectContaining({ type: 'explosion' })]) });
    expect(played(composePlayer([aliens])(chased, options))).toEqual(whole);
    expect(played(composePlayer([aliens, manyObjects])(chased, options))).toEqual(whole);
  });

  test('with ghosts, snapshots and restarts', () => {
    const { level } = pack[pack.length - 1];
    const options = { ghosts: [{ name: 'own', holds: level.runs[0].holds }] };
    const [light, whole] = [composePlayer(partsFor(level))(level, options), createPlayer(level, options)];
    const pose = [new Float64Array(6), new Float64Array(6)];
    for (const [i, player] of [light, whole].entries()) {
      player.press();
      player.advance(90);
      const before = player.snapshot();
      player.release();
      player.advance(90);
      player.restore(before);
      player.advance(50);
      player.ghosts[0].readPose(pose[i]);
    }
    expect(light.hash).toBe(whole.hash);
    expect(pose[0]).toEqual(pose[1]);
  });
});

describe('a level that calls for a part that is not included is refused by name', () => {
  const object = { id: null, x: 500, y: 500, radius: 16 };
  test.each([
    ['aliens', { aliens: [object] }],
    ['repulsors', { repulsors: [object] }],
    ['winds', { winds: [{ ...object, ax: 0, ay: 1 }] }],
    ['wormholes', { wormholes: [{ ...object, toX: 600, toY: 600 }] }],
    ['recoil', { recoil: true }],
    ['manyObjects', { novae: Array.from({ length: 128 }, () => object) }],
    ['manyObjects', { wormholes: Array.from({ length: 64 }, () => ({ ...object, toX: 600, toY: 600 })) }],
  ] as const)('%s', (name, own) => {
    const level: Level = { ...EMPTY, ...own };
    const others = PARTS.filter((part) => part.name !== name);
    expect(() => composePlayer(others)(level)).toThrow(
      new RegExp(`^expected a level without .*, since the part "${name}" is not included`),
    );
    expect(composePlayer([...PARTS, manyObjects])(level).tick).toBe(0);
  });

  test('127 objects of a kind are not many', () => {
    const novae = Array.from({ length: 127 }, (_, i) => ({ ...object, x: 1000 + i }));
    expect(composePlayer()({ ...EMPTY, novae }).tick).toBe(0);
  });

  test('there is a part for every list of a level, and every effect belongs to one or to all levels', () => {
    const level = Object.fromEntries(
      LISTED_KINDS.map((kind) => [listOf(kind), [{ ...object, hot: false, ax: 0, ay: 0, toX: 0, toY: 9 }]]),
    );
    const full = { ...EMPTY, ...level, aliens: [object, object], recoil: true } as Level;
    const { simulated, notCalledFor } = composePlayer(PARTS)(full).scene.effects;
    const names = EFFECTS.map(({ name }) => name);
    expect([...simulated, ...notCalledFor].map(({ name }) => name).sort()).toEqual([...names].sort());
    expect(createPlayer(full).scene.effects.simulated).toEqual(simulated);
  });

  test('another accuracy is refused, too', () => {
    expect(() => composePlayer()(EMPTY, { accuracy: 'arcade' } as never)).toThrow('expected the accuracy precise, found arcade');
    expect(composePlayer()(EMPTY, { accuracy: 'precise' } as never).tick).toBe(0);
  });
});

test('the reader is that of the complete game', () => {
  expect(readHere).toBe(readLevel);
});
