import { describe, expect, test } from 'vitest';
import { type RenderOptions, renderSvg } from '../../picture/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { count, DROP, FULL, level, play } from './scenes.ts';

const HOLDS: [number, number][] = [
  [10, 40],
  [60, 200],
];

describe('a picture shows what the level has', () => {
  test('an element for each object, of its own kind', () => {
    const svg = renderSvg(level(FULL));
    const kinds = {
      asteroid: 2,
      'hot-asteroid': 1,
      nova: 1,
      repulsor: 1,
      alien: 2,
      sight: 2,
      mineral: 3,
      'black-hole': 1,
      astronaut: 1,
      range: 3,
    };
    for (const [kind, n] of Object.entries(kinds)) expect([kind, count(svg, kind)]).toEqual([kind, n]);
    // The hot one keeps its index in the level's list.
    expect(svg).toContain('data-kind="hot-asteroid" data-index="2"');
  });

  test('without a run there is no path, no end and no outcome', () => {
    const svg = renderSvg(level(FULL));
    for (const kind of ['way', 'held', 'coasting', 'seconds', 'presses', 'contact', 'astronaut-end', 'timeline'])
      expect(count(svg, kind)).toBe(0);
  });

  test('a crowded level is drawn as specks, still one for each object', () => {
    const asteroids = Array.from({ length: 2000 }, (_, i) => ({
      x: 20 * (i % 50),
      y: 20 * Math.floor(i / 50),
      radius: 8,
      hot: i % 2 === 0,
    }));
    const svg = renderSvg(level({ ...FULL, asteroids }));
    expect([count(svg, 'asteroid'), count(svg, 'hot-asteroid'), count(svg, 'alien')]).toEqual([1000, 1000, 2]);
    expect(svg.length).toBeLessThan(2000 * 250);
  });

  test('a small picture is crowded with fewer objects', () => {
    const asteroids = Array.from({ length: 400 }, (_, i) => ({ x: 30 * (i % 20), y: 30 * Math.floor(i / 20), radius: 8 }));
    const crowd = level({ ...FULL, asteroids });
    const [small, large] = [144, 960].map((width) => renderSvg(crowd, { width, words: false }));
    expect([count(small, 'asteroid'), count(large, 'asteroid')]).toEqual([400, 400]);
    expect(small.length).toBeLessThan(large.length / 3);
  });
});

describe('very small objects', () => {
  const asteroid = (radius: number) => {
    const svg = renderSvg(level({ ...DROP, asteroids: [{ x: 0, y: 120, radius }] }));
    const scale = Number(/data-kind="asteroid"[^>]*scale\(([\d.]+)\)/.exec(svg)?.[1]);
    const drawn = svg.slice(svg.indexOf('data-kind="asteroid"'));
    return [...drawn.slice(0, drawn.indexOf('data-kind', 1)).matchAll(/<circle r="([\d.]+)"/g)].map(([, r]) => Number(r) * scale);
  };

  test('are drawn large enough to see, in a ring that shows it', () => {
    const [disc, ring] = asteroid(1);
    expect(disc).toBeGreaterThan(3.9);
    expect(ring).toBeCloseTo(2 * disc, 1);
    expect(asteroid(1)).toEqual(asteroid(0.001));
  });

  test('are drawn in their own size, without a ring, once they are large enough', () => {
    const [disc, ...ring] = asteroid(16);
    expect([disc / asteroid(32)[0], ring]).toEqual([expect.closeTo(0.5, 2), []]);
  });
});

describe('a picture shows what the run did', () => {
  const run = play(DROP, HOLDS);
  const svg = renderSvg(level(DROP), { run });

  test('a thick line for each hold, thin ones between, a number for each press', () => {
    expect(run.outcome).toBe('completed');
    expect(count(svg, 'held')).toBe(2);
    expect(count(svg, 'coasting')).toBe(run.time > 200 / 60 ? 3 : 2);
    const presses = svg.slice(svg.indexOf('data-kind="presses"'));
    expect(presses.slice(0, presses.indexOf('</g>')).split('<circle').length - 1).toBe(2);
  });

  test('a dot for each whole second', () => {
    const dots = svg.slice(svg.indexOf('data-kind="seconds"'));
    expect(dots.slice(0, dots.indexOf('</g>')).split('<circle').length - 1).toBe(Math.ceil(run.trajectory.duration) - 1);
  });

  test('collected minerals are ticked, the others are not', () => {
    expect(svg).toContain('data-kind="collected" data-index="0"');
    expect(svg).not.toContain('data-kind="collected" data-index="1"');
    expect(svg).toContain('1 of 2 minerals');
  });

  test('the line ends where the run ends, and follows it everywhere', () => {
    // Level px to units of the picture, from two known places.
    const at = (kind: string): [number, number] => {
      const found = new RegExp(`data-kind="${kind}" data-index="0" transform="translate\\(([-\\d.]+) ([-\\d.]+)\\)`).exec(svg);
      return [Number(found?.[1]), Number(found?.[2])];
    };
    const [startX, startY] = at('astronaut');
    const [, holeY] = at('black-hole');
    const scale = (holeY - startY) / 260;
    const ds = [...svg.matchAll(/data-kind="(?:held|coasting)" d="M([^"]+)"/g)].map(([, d]) =>
      d.split('L').map((p) => p.split(' ').map(Number)),
    );
    expect(ds[0][0]).toEqual([startX, startY]);
    const [endX, endY] = ds.at(-1)?.at(-1) ?? [];
    expect(endX).toBeCloseTo(startX + run.final.x * scale, 1);
    expect(endY).toBeCloseTo(startY + run.final.y * scale, 1);
    // Stretches join without a gap.
    for (let i = 1; i < ds.length; i++) expect(ds[i][0]).toEqual(ds[i - 1].at(-1));
  });

  test.each<[string, LevelFile, string]>([
    ['completed', DROP, 'completed in'],
    ['collided', { ...DROP, novae: [{ x: 0, y: 200, radius: 16 }] }, 'burned by nova 1'],
    ['lost', { ...DROP, astronaut: { x: 0, y: 0, vx: -90 } }, 'lost at'],
  ])('%s is marked as such', (outcome, file, words) => {
    const end = play(file, HOLDS);
    expect(end.outcome).toBe(outcome);
    const picture = renderSvg(level(file), { run: end });
    expect(picture).toContain(`data-kind="contact" data-outcome="${outcome}"`);
    expect(picture).toContain(`<desc>${words}`);
    expect(count(picture, 'astronaut-end')).toBe(1);
  });

  test('a run that ended by time has no contact', () => {
    const drift = play(DROP, [], 2);
    const picture = renderSvg(level(DROP), { run: drift });
    expect([drift.outcome, count(picture, 'contact')]).toEqual(['timeout', 0]);
  });

  test('a lured pair of aliens leaves its paths', () => {
    const file = {
      ...DROP,
      aliens: [
        { x: 60, y: -60 },
        { x: 120, y: -60 },
      ],
    };
    expect(count(renderSvg(level(file), { run: play(file, HOLDS) }), 'alien-way')).toBe(2);
  });
});

describe('any level gives a picture, and always the same one', () => {
  test('the same input gives the same text, in both themes', () => {
    const run = play(FULL, HOLDS);
    for (const theme of ['dark', 'light'] as const) {
      expect(renderSvg(level(FULL), { run, theme })).toBe(renderSvg(level(FULL), { run, theme }));
    }
    expect(renderSvg(level(FULL), { theme: 'light' })).not.toBe(renderSvg(level(FULL)));
  });

  test('moving the whole level gives the same picture', () => {
    const move = <T extends { x: number; y: number }>(o: T): T => ({ ...o, x: o.x + 1024, y: o.y - 2048 });
    const moved: LevelFile = {
      ...DROP,
      astronaut: move(DROP.astronaut),
      blackHole: move(DROP.blackHole),
      asteroids: DROP.asteroids?.map(move),
      minerals: DROP.minerals?.map(move),
    };
    expect(renderSvg(level(moved))).toBe(renderSvg(level(DROP)));
  });

  test.each<[string, Partial<LevelFile>, RenderOptions]>([
    ['nothing but what it must have', { asteroids: [], minerals: [] }, {}],
    ['a universe wide', { astronaut: { x: -1e9, y: -1e9 }, blackHole: { x: 1e9, y: 1e9, radius: 1e6 } }, {}],
    ['all in one place', { blackHole: { x: 0, y: 0 }, asteroids: [{ x: 0, y: 0, radius: 1e-9 }] }, {}],
    ['a run that ends at once', { asteroids: [] }, { run: play({ ...DROP, asteroids: [] }, []) }],
    ['holds without a run, and none', {}, { holds: [] }],
  ])('%s: every number is finite', (_, more, options) => {
    const svg = renderSvg(level({ ...DROP, ...more }), options);
    expect(svg.replace(/#[0-9a-f]+/g, '').match(/NaN|Infinity|undefined|null|\de[+-]?\d/g)).toBeNull();
  });

  test('numbers have two decimals at most, and a long run stays small', () => {
    const run = play(FULL, [[0, 1200]]);
    const svg = renderSvg(level(FULL), { run });
    expect(svg.replace(/scale\([^)]*\)/g, '').match(/\d\.\d{3,}/g)).toBeNull();
    expect(svg.length).toBeLessThan(100_000);
  });

  test('the width is as requested, and the height follows', () => {
    const size = (width: number) =>
      /width="([\d.]+)" height="([\d.]+)" viewBox="0 0 ([\d.]+) ([\d.]+)"/
        .exec(renderSvg(level(FULL), { width }))
        ?.slice(1)
        .map(Number) ?? [];
    const [width, height, boxWidth, boxHeight] = size(480);
    expect(width).toBe(480);
    expect(height / width).toBeCloseTo(boxHeight / boxWidth, 3);
  });
});
