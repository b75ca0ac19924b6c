import { describe, expect, it } from 'vitest';
import { playableLevel } from '../../bench/editor/playable-level.ts';
import { hitTest, REACH } from '../../editor/canvas/hit-test.ts';
import { objectsOf } from '../../editor/document/index.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';

/** 20 asteroids of 16 px in a row, 100 px apart. */
const level = () => ({
  ...playableLevel(4),
  asteroids: Array.from({ length: 20 }, (_, i) => ({ id: `a${i}`, x: 100 * i, y: 500, radius: 16 })),
});

const keys = (count: number) =>
  [...objectsOf(level()).values()].flatMap(({ key, kind }) => (kind === 'asteroid' ? [key] : [])).slice(0, count);

const at = (x: number, zoom: number, selected: number) =>
  hitTest(level(), boxOf(DEFAULT_RULES), { x, y: 500 }, REACH.mouse / zoom, keys(selected))?.part;

describe('what the pointer takes', () => {
  it('is the rim of a selected object, its middle, and nothing farther than it reaches', () => {
    expect([0, 14, 19, 24].map((x) => at(x, 1, 1))).toEqual(['body', 'rim', 'rim', undefined]);
    expect(at(14, 1, 0)).toBe('body');
  });

  it('is never the rim of an object too small on the screen to tell it from the middle', () => {
    expect([0, 8, 16, 30].map((x) => at(x, 0.08, 1))).toEqual(['body', 'body', 'body', 'body']);
  });

  it('is never the rim where many are selected, which have no handles', () => {
    expect([12, 13].map((selected) => at(14, 1, selected))).toEqual(['rim', 'body']);
  });
});
