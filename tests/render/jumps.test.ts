import { expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { stretchesOf } from '../../picture/way.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { plainLevel } from '../engine/plain-level.ts';

it.each(accuracyNames)('a path through a wormhole is drawn as two lines, none of them from mouth to mouth: %s', (accuracy) => {
  const level = {
    ...plainLevel({ astronaut: { x: 0, y: 0, vx: 60, vy: 0 } }),
    wormholes: [{ id: null, x: 100, y: 0, toX: 400, toY: 300, radius: 20 }],
  };
  const stretches = stretchesOf(simulate(compile(level, accuracy), [], { maxTime: 4 }));
  expect(stretches).toHaveLength(2);
  const lengths = stretches.map(({ points }) =>
    Math.hypot(points[points.length - 1][0] - points[0][0], points[points.length - 1][1] - points[0][1]),
  );
  // 240 px flown, except for the tick in which she jumps.
  expect(lengths[0] + lengths[1]).toBeGreaterThan(237);
  expect(lengths[0] + lengths[1]).toBeLessThan(240.001);
  // A run without a wormhole is one line.
  expect(stretchesOf(simulate(compile({ ...level, wormholes: [] }, accuracy), [], { maxTime: 4 }))).toHaveLength(1);
});
