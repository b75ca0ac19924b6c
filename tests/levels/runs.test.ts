import { describe, expect, it } from 'vitest';
import { type AccuracyName, compile, simulate } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { accuracyNames, keepsPromise, pack, play } from './shipped-pack.ts';

// A run is a promise that a player can keep: it works at every accuracy, and with every edge slightly early or late.

const runs = pack.flatMap(({ slug, level }) => level.runs.map((run) => ({ slug, level, name: run.name, holds: run.holds })));

/** Ticks by which a single edge is moved: 67 ms. */
const ONE_EDGE = [-4, -2, -1, 1, 2, 4];
/** Ticks by which all edges are moved together. */
const ALL_EDGES = [-2, -1, 1, 2];

const moved = (holds: readonly Hold[], by: (edge: number) => number): Hold[] =>
  holds.map(([press, release], i) => [press + by(2 * i), release + by(2 * i + 1)]);

function shiftsOf(holds: readonly Hold[]): Map<string, Hold[]> {
  const shifts = new Map<string, Hold[]>();
  for (let edge = 0; edge < 2 * holds.length; edge++) {
    for (const d of ONE_EDGE)
      shifts.set(
        `edge ${edge} by ${d}`,
        moved(holds, (e) => (e === edge ? d : 0)),
      );
  }
  for (const d of ALL_EDGES)
    shifts.set(
      `all by ${d}`,
      moved(holds, () => d),
    );
  return shifts;
}

describe.each(runs)('$slug, run $name', ({ level, name, holds }) => {
  it.each(accuracyNames)('keeps its promise under %s', (accuracy) => {
    expect(keepsPromise(level, name, play(level, name, accuracy))).toBe(true);
  });

  it('is short, and its presses are far enough apart for a thumb', () => {
    const run = play(level, name, 'arcade');
    expect(run.time).toBeLessThan(25);
    expect(holds.length).toBeGreaterThan(0);
    expect(holds.length).toBeLessThanOrEqual(8);
    const edges = holds.flat();
    for (let i = 1; i < edges.length; i++) expect(edges[i] - edges[i - 1]).toBeGreaterThanOrEqual(6);
    // every hold is needed: none begins after the end of the run
    expect(holds[holds.length - 1][0]).toBeLessThan(run.tick);
  });

  it.each(['arcade', 'precise'] satisfies AccuracyName[])('forgives a press or release 4 ticks off under %s', (accuracy) => {
    const scene = compile(level, accuracy);
    const broken = [...shiftsOf(holds)].filter(([, shifted]) => !keepsPromise(level, name, simulate(scene, shifted)));
    expect(broken.map(([shift]) => shift)).toEqual([]);
  });
});

it('a broken promise is detected: the first level without a press', () => {
  const { level } = pack[0];
  expect(keepsPromise(level, 'solution', simulate(compile(level, 'arcade'), []))).toBe(false);
});

it('a missing mineral is detected: a solution that does not collect all', () => {
  const leaves = pack.filter(({ level }) => level.minerals.length > 0 && play(level, 'solution', 'arcade').minerals.length === 0);
  expect(leaves.length).toBeGreaterThan(0);
  for (const { level } of leaves) expect(keepsPromise(level, 'all-minerals', play(level, 'solution', 'arcade'))).toBe(false);
});
