import { beforeAll, describe, expect, it } from 'vitest';
import { loadPeers, PEERS, type Peer, simulatePeer } from '../../bench/peers/index.ts';
import { referenceEnd } from '../../bench/reference.ts';
import type { Level } from '../../schema/index.ts';
import { once } from '../once.ts';
import { FALL, fallDistance, ORBIT, TWELVE_CIRCLES } from '../scenes/index.ts';

// A peer that was driven wrongly would still draw a nice curve: with an ever smaller step each must come to the same motion,
// and its contacts must say what ours say.

beforeAll(async () => {
  await loadPeers();
});

/** Where single precision stops getting better, px, at coordinates of some hundred px. */
const SINGLE_FLOOR = 0.05;

const fallError = (peer: Peer, rate: number): number => {
  const { samples } = simulatePeer(peer, FALL.level, FALL.holds, FALL.seconds, rate);
  const [, x, y] = samples[samples.length - 1];
  return Math.hypot(x + fallDistance(FALL.seconds), y);
};

const SECONDS = 5;
const orbitTruth = once(() => referenceEnd(ORBIT.level, ORBIT.holds, SECONDS, 960));

const orbitError = (peer: Peer, rate: number): number => {
  const { samples } = simulatePeer(peer, ORBIT.level, ORBIT.holds, SECONDS, rate);
  const [, x, y, vx, vy] = samples[samples.length - 1];
  const truth = orbitTruth();
  return Math.max(Math.hypot(x - truth[0], y - truth[1]), Math.hypot(vx - truth[2], vy - truth[3]));
};

/** {@link FALL} with its asteroid hot. */
const HOT_FALL: Level = { ...FALL.level, asteroids: FALL.level.asteroids.map((a) => ({ ...a, hot: true })) };

describe.each(PEERS.map((peer) => [peer.name, peer] as const))('%s', (_, peer) => {
  const floor = peer.precision === 'single' ? SINGLE_FLOOR : 0;

  it('falls towards one asteroid by the closed form as its step shrinks', () => {
    const coarse = fallError(peer, 60);
    const fine = fallError(peer, 960);
    expect(coarse).toBeLessThan(2);
    // first order: 16 times the rate, a 16th of the error
    expect(fine).toBeLessThan(Math.max(coarse / 12, floor));
  });

  it('swings around one of twelve circles by the reference as its step shrinks', () => {
    const coarse = orbitError(peer, 60);
    const fine = orbitError(peer, 960);
    expect(coarse).toBeLessThan(2);
    expect(fine).toBeLessThan(Math.max(coarse / 12, floor));
  });

  it('reports the touch of a hot asteroid when her side reaches it', () => {
    const { outcome, outcomeTime } = simulatePeer(peer, HOT_FALL, FALL.holds, 6, 240);
    // side (10) and radius (16) meet at d = 26
    const touch = Math.acosh((FALL.level.range - 26) / (FALL.level.range - fallDistance(0))) / Math.sqrt(39 / FALL.level.range);
    expect(outcome).toBe('collided');
    expect(Math.abs((outcomeTime ?? 0) - touch)).toBeLessThan(5 / 240);
  });

  it('passes through a cold asteroid without an outcome', () => {
    expect(simulatePeer(peer, FALL.level, FALL.holds, 6, 240).outcome).toBeNull();
  });

  it('reports the black hole, and being out of range', () => {
    const hole: Level = { ...FALL.level, blackHole: { x: -120, y: 0, radius: 18 } };
    expect(simulatePeer(peer, hole, FALL.holds, 6, 240).outcome).toBe('completed');
    const leaving: Level = { ...FALL.level, astronaut: { x: -200, y: 0, vx: -40, vy: 0 } };
    expect(simulatePeer(peer, leaving, [], 3, 60).outcome).toBe('lost');
  });

  it('lives through the minute among twelve circles that it is timed on', () => {
    expect(simulatePeer(peer, TWELVE_CIRCLES.level, TWELVE_CIRCLES.holds, TWELVE_CIRCLES.seconds, 60).outcome).toBeNull();
  });

  it('refuses a level it cannot be driven through', () => {
    expect(() => peer.create({ ...FALL.level, recoil: true }, 60)).toThrow(/found recoil/);
    const windy = { ...FALL.level, winds: [{ id: null, x: 0, y: 0, radius: 10, ax: 1, ay: 0 }], rules: { pull: 45 } };
    expect(() => peer.create(windy, 60)).toThrow(/found winds, rules of its own/);
  });
});
