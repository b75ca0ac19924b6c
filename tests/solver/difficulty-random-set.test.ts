import { describe, expect, it } from 'vitest';
import { formatLevel, readLevel } from '../../schema/index.ts';
import { once } from '../once.ts';
import { hashRandomSet, layoutOf, RANDOM_SET_HASH, RANDOM_SET_SIZE, randomLevel } from '../scenes/random-set/index.ts';

const levelOf = once(randomLevel);

// Published figures of the solver refer to this very set: one changed number in one level makes it another set.
describe('the frozen random set', () => {
  it('has the published hash', () => {
    expect(hashRandomSet()).toBe(RANDOM_SET_HASH);
  });

  it('has the stated properties', () => {
    const seen = {
      novae: new Set<number>(),
      asteroids: new Set<number>(),
      aliens: 0,
      repulsors: 0,
      hot: 0,
      recoil: 0,
      moving: 0,
    };
    for (let seed = 0; seed < RANDOM_SET_SIZE; seed++) {
      const reading = readLevel(formatLevel(levelOf(seed)));
      if (!reading.ok) throw new Error(`level ${seed}: ${reading.problems[0].message}`);
      const { asteroids, novae, aliens, repulsors, recoil, astronaut } = reading.level;
      seen.novae.add(novae.length);
      seen.asteroids.add(asteroids.length);
      if (aliens.length > 0) seen.aliens++;
      if (repulsors.length > 0) seen.repulsors++;
      if (asteroids.some(({ hot }) => hot)) seen.hot++;
      if (recoil) seen.recoil++;
      if (astronaut.vx !== 0 || astronaut.vy !== 0) seen.moving++;
    }
    expect([Math.min(...seen.novae), Math.max(...seen.novae)]).toEqual([5, 120]);
    expect([Math.min(...seen.asteroids), Math.max(...seen.asteroids)]).toEqual([1, 15]);
    const share = (count: number) => count / RANDOM_SET_SIZE;
    expect(share(seen.aliens)).toBeCloseTo(0.4, 1);
    expect(share(seen.repulsors)).toBeCloseTo(0.4, 1);
    expect(share(seen.recoil)).toBeCloseTo(0.5, 1);
    expect(share(seen.moving)).toBeCloseTo(0.2, 1);
    expect(share(seen.hot)).toBeGreaterThan(0.3);
  });

  it('keeps the start of chained levels free', () => {
    for (let seed = 1; seed < RANDOM_SET_SIZE; seed += 2) {
      if (layoutOf(seed) !== 'chained') expect.fail(`level ${seed} is not chained`);
      const { astronaut, novae, aliens, asteroids } = levelOf(seed);
      const deadly = [...novae!, ...aliens!, ...asteroids!.filter(({ hot }) => hot)];
      const nearest = Math.min(...deadly.map(({ x, y }) => Math.hypot(x - astronaut.x, y - astronaut.y)));
      if (!(nearest > 60)) expect.fail(`level ${seed}: a hazard ${nearest} px from the start`);
    }
  });
});
