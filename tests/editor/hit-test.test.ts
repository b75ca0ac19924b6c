import { describe, expect, it } from 'vitest';
import { hitTest, REACH } from '../../editor/canvas/hit-test.ts';
import { objectsOf } from '../../editor/document/index.ts';
import { boxOf } from '../../engine/index.ts';
import { DEFAULT_RULES } from '../../schema/index.ts';
import { playableLevel } from '../scenes/playable-level.ts';

/** 20 asteroids of 16 px in a row, 100 px apart. */
const level = () => ({
  ...playableLevel(4),
  asteroids: Array.from({ length: 20 }, (_, i) => ({ id: `a${i}`, x: 100 * i, y: 500, radius: 16 })),
});

const keys = (count: number) =>
  [...objectsOf(level()).values()].flatMap(({ key, kind }) => (kind === 'asteroid' ? [key] : [])).slice(0, count);

const at = (x: number, zoom: number, selected: number) =>
  hitTest(level(), boxOf(DEFAULT_RULES), { x, y: 500 }, REACH.mouse / zoom, keys(selected))?.part;

describe('the pointer', () => {
  it('hits the rim or the middle of a selected object, and nothing beyond its reach', () => {
    expect([0, 14, 19, 24].map((x) => at(x, 1, 1))).toEqual(['body', 'rim', 'rim', undefined]);
    expect(at(14, 1, 0)).toBe('body');
  });

  it('never hits the rim of an object that is too small on the screen', () => {
    expect([0, 8, 16, 30].map((x) => at(x, 0.08, 1))).toEqual(['body', 'body', 'body', 'body']);
  });

  it('never hits a rim if many objects are selected, which have no handles', () => {
    expect([12, 13].map((selected) => at(14, 1, selected))).toEqual(['rim', 'body']);
  });
});
