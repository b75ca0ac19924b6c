import { describe, expect, it } from 'vitest';
import { linesOf } from '../../editor/canvas/layers/way-layer.ts';
import { poseAt } from '../../editor/canvas/picture.ts';
import { createProver } from '../../editor/core/proof/index.ts';
import { pathOfHolds } from '../../editor/features/solver/ghosts.ts';
import { everyTick } from '../../editor/features/solver/robustness-watch.ts';
import { compile, DEFAULT_TERMS, TICK } from '../../engine/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { plainLevel } from '../engine/plain-level.ts';
import { randomScene } from '../scenes/random-scene.ts';

const through = (vx: number) => ({
  ...plainLevel({ astronaut: { x: 0, y: 0, vx, vy: 0 } }),
  wormholes: [{ id: null, x: 100, y: 0, toX: 400, toY: 300, radius: 20 }],
});

/** The longest segment of some lines, px. */
const longest = (lines: ReturnType<typeof linesOf>): number =>
  Math.max(
    0,
    ...lines.flatMap((line) =>
      Array.from({ length: line.length / 2 - 1 }, (_, i) =>
        Math.hypot(line[2 * i + 2] - line[2 * i], line[2 * i + 3] - line[2 * i + 1]),
      ),
    ),
  );

describe.each(accuracyNames)('the lines of a ghost at %s', (accuracy) => {
  it.each([20, 60, 300, 900])('are interrupted where a wormhole moves her at %d px/s', (vx) => {
    const scene = compile(through(vx), accuracy);
    const points = pathOfHolds(scene, [], Math.round((200 / vx) * 60));
    const lines = linesOf(points);
    expect(lines).toHaveLength(2);
    // a segment has three ticks
    expect(longest(lines)).toBeLessThan(3 * TICK * vx + 1e-3);
    // a path that is known at every third tick, and interpolated
    const rare = points.filter((_, i) => Math.floor(i / 2) % 3 === 0);
    expect(linesOf(everyTick(rare, 3))).toHaveLength(2);
  });

  it('are one line without jumps, however she flies', () => {
    for (let seed = 0; seed < 150; seed++) {
      const { level, holds } = randomScene(seed);
      const points = pathOfHolds(compile(level, accuracy), holds, 300);
      const lines = linesOf(points);
      expect({ seed, lines: lines.length }).toEqual({ seed, lines: 1 });
      // all of it is drawn, except the rest of the last segment
      expect(lines[0].length).toBe(2 * Math.ceil(points.length / 6));
    }
  });
});

it('playback never shows her between the mouths of a wormhole', () => {
  const file: LevelFile = {
    version: 1,
    name: 'Through',
    astronaut: { x: 0, y: 0, vx: 60, vy: 0 },
    blackHole: { x: 600, y: 300 },
    asteroids: [{ x: 200, y: 200, radius: 16 }],
    range: 1000,
    wormholes: [{ x: 100, y: 0, toX: 400, toY: 300, radius: 20 }],
  };
  const proof = createProver().prove({ file, run: null, terms: DEFAULT_TERMS });
  let before = poseAt(proof, 0);
  let leaps = 0;
  for (let tick = 0; tick < proof.run.way.count - 1; tick += 1 / 8) {
    const pose = poseAt(proof, tick);
    const step = Math.hypot(pose.x - before.x, pose.y - before.y);
    // an eighth of a tick at 60 px/s; the jump happens at a tick
    if (step > 400) leaps++;
    else expect(step).toBeLessThan(0.2);
    before = pose;
  }
  expect(leaps).toBe(1);
});
