// Pictures follow the table of kinds: each has a drawing, a speck, a place in the frame and an entry in the legend.

import { describe, expect, it } from 'vitest';
import { renderSvg } from '../../picture/index.ts';
import { IN_PICTURE } from '../../picture/kinds/index.ts';
import { THEMES } from '../../picture/theme.ts';
import {
  DEFAULT_RULES,
  fieldsOf,
  isRequired,
  KINDS,
  type LevelFile,
  LISTED_KINDS,
  listOf,
  OBJECT_KINDS,
  resolveLevel,
} from '../../schema/index.ts';
import { count } from './scenes.ts';

const BARE: LevelFile = { version: 1, name: 'bare', astronaut: { x: 0, y: 0 }, blackHole: { x: 300, y: 0 } };

/** A level with so many objects of a kind, far apart and far away. */
function levelWith(kind: (typeof LISTED_KINDS)[number], many: number, more: object = {}) {
  const { places } = KINDS[kind];
  const objects = Array.from({ length: many }, (_, i) => {
    const object: Record<string, unknown> = { ...more };
    for (const [name, field] of fieldsOf(kind)) {
      if (field.type === 'number' && isRequired(field)) object[name] = field.initial ?? 0;
    }
    for (const [k, [x, y]] of places.entries())
      Object.assign(object, { [x]: 2000 + 100 * k + (i % 40) * 300, [y]: 1000 + 90 * Math.floor(i / 40) });
    return object;
  });
  return resolveLevel({ ...BARE, [listOf(kind)]: objects } as LevelFile);
}

const nameOf = (words: string) => words.replaceAll(' ', '-');

describe.each(LISTED_KINDS)('%s in pictures', (kind) => {
  const { one, places, variant } = KINDS[kind];

  it.each(['dark', 'light'] as const)('is drawn at each of its places, in %s', (theme) => {
    const svg = renderSvg(levelWith(kind, 2), { theme });
    expect(count(svg, nameOf(one))).toBe(2 * places.length);
    expect(svg).not.toMatch(/NaN|undefined|null/);
    if (variant === undefined) return;
    const varied = renderSvg(levelWith(kind, 2, { [variant.flag]: true }), { theme });
    expect(count(varied, nameOf(variant.one))).toBe(2 * places.length);
    expect(varied).not.toBe(svg);
  });

  it('lies within the frame with all of its places', () => {
    const svg = renderSvg(levelWith(kind, 2));
    const [, width, height] = (/viewBox="0 0 (\d+) ([\d.]+)"/.exec(svg) ?? []).map(Number);
    const at = [
      ...svg.matchAll(
        new RegExp(`data-kind="${nameOf(one)}" data-index="\\d+" transform="translate\\(([-\\d.]+) ([-\\d.]+)\\)`, 'g'),
      ),
    ];
    expect(at).toHaveLength(2 * places.length);
    for (const [, x, y] of at.map((match) => match.map(Number))) {
      expect(x).toBeGreaterThan(0);
      expect(x).toBeLessThan(width);
      expect(y).toBeGreaterThan(0);
      expect(y).toBeLessThan(height);
    }
  });

  it('has an entry in the legend exactly if the level has it', () => {
    const legendOf = (svg: string) => svg.slice(svg.indexOf('data-kind="legend"')).length;
    expect(IN_PICTURE[kind].legend).not.toBeNull();
    expect(legendOf(renderSvg(levelWith(kind, 1)))).toBeGreaterThan(legendOf(renderSvg(levelWith(kind, 0))));
  });

  it('is a speck with its own shape where there are very many', () => {
    const look = { object: levelWith(kind, 1)[listOf(kind)][0], place: 0, radius: 16, index: 0, rules: DEFAULT_RULES };
    const specks = LISTED_KINDS.map((other) => {
      const object = levelWith(other, 1)[listOf(other)][0];
      return IN_PICTURE[other].speck({ ...look, object, theme: THEMES.dark });
    });
    expect(new Set(specks.map((speck) => speck.replace(/#[0-9a-f]{6}/g, ''))).size).toBe(specks.length);
    const many = levelWith(kind, 1600);
    const svg = renderSvg(many, { words: false });
    expect(count(svg, nameOf(one))).toBe(1600 * places.length);
    expect(svg).toContain(IN_PICTURE[kind].speck({ ...look, radius: many[listOf(kind)][0].radius, theme: THEMES.dark }));
  });
});

it('every kind that can be placed is drawn among the objects, each at its own depth', () => {
  const depths = OBJECT_KINDS.flatMap((kind) =>
    [IN_PICTURE[kind].depth, IN_PICTURE[kind].around?.depth].filter((depth) => depth != null),
  );
  expect(new Set(depths).size).toBe(depths.length);
  for (const kind of LISTED_KINDS) expect(IN_PICTURE[kind].depth).not.toBeNull();
});
