import { describe, expect, test } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { drawDifficulty } from '../../picture/difficulty/index.ts';
import { heatCaption, heatColour, heatShades, renderSvg, visitsInWords } from '../../picture/index.ts';
import type { LevelFile } from '../../schema/index.ts';
import { count, FULL, level, play } from './scenes.ts';

const HOLDS: [number, number][] = [
  [10, 40],
  [60, 200],
];

/** For each text drawn as strokes: where it begins, its scale, and how far it extends before that. */
const letters = (svg: string): readonly [svg: string, x: number, scale: number, reach: number][] =>
  [...svg.matchAll(/<path d="([^"]*)" transform="translate\(([\d.-]+) [^)]*\) scale\(([\d.]+)\)" fill="none"/g)].map(
    ([all, d, x, scale]) => [
      all,
      Number(x),
      Number(scale),
      Math.max(0, ...[...d.matchAll(/M([\d.-]+) /g)].map(([, at]) => Number(at))),
    ],
  );

describe('several runs', () => {
  const full = level(FULL);
  const runs = [HOLDS, [], [[0, 300]] as [number, number][]].map((holds, i) => ({
    run: simulate(compile(full), holds),
    label: `way ${i}`,
  }));
  const svg = renderSvg(full, { ways: runs });

  test('have a path, two numbers and a timeline each, and no single run is drawn', () => {
    expect([count(svg, 'way'), count(svg, 'badge'), count(svg, 'timeline')]).toEqual([3, 6, 3]);
    expect([count(svg, 'astronaut-end'), count(svg, 'presses')]).toEqual([0, 0]);
  });

  test('show where they fail', () => {
    const failed = runs.filter(({ run }) => run.outcome === 'collided' || run.outcome === 'lost').length;
    expect(failed).toBeGreaterThan(0);
    expect(count(svg, 'contact')).toBe(failed);
  });
});

test('explored places: every cell is drawn, in at most seven shades, and more visits are never fainter', () => {
  const cells = Array.from({ length: 50 }, (_, i) => ({ x: 10 * i, y: 0, visits: 1 + (i % 10) }));
  const svg = renderSvg(level(FULL), { explored: { cellSize: 10, cells } });
  const [, group = ''] = /<g data-kind="explored"[^>]*>(.*?)<\/g>/.exec(svg) ?? [];
  const shades = [...group.matchAll(/<path d="([^"]*)" fill-opacity="([\d.]+)"/g)];
  expect(shades.length).toBeLessThanOrEqual(7);
  const opacity = new Map<number, number>();
  for (const [, d, value] of shades) for (const [, x] of d.matchAll(/M([\d.-]+) /g)) opacity.set(Number(x), Number(value));
  expect(opacity.size).toBe(50);
  const byPlace = [...opacity].sort(([a], [b]) => a - b).map(([, value]) => value);
  for (let i = 0; i < 50; i++) {
    for (let k = 0; k < 50; k++) {
      if (cells[i].visits < cells[k].visits) expect(byPlace[i]).toBeLessThanOrEqual(byPlace[k]);
      if (cells[i].visits === cells[k].visits) expect(byPlace[i]).toBe(byPlace[k]);
    }
  }
});

test('explored places: the legend says what is counted and what each shade stands for, in numbers', () => {
  const cells = Array.from({ length: 70 }, (_, i) => ({ x: 32 * i, y: 0, visits: 10 * (i + 1) }));
  const explored = { cellSize: 32, cells };
  const shades = heatShades(explored);
  expect(heatCaption(explored)).toBe('visits of the search to each square of 32 px');
  expect(shades.map(visitsInWords)).toEqual(['10–100', '110–200', '210–300', '310–400', '410–500', '510–600', '610–700']);
  expect(shades.flatMap((shade) => shade.cells)).toHaveLength(70);
  expect(visitsInWords({ least: 3, most: 3 })).toBe('3');
  expect(visitsInWords({ least: 9999, most: 12_345_678 })).toBe('9999–12.3M');
  for (const theme of ['dark', 'light'] as const) {
    const svg = renderSvg(level(FULL), { explored, theme });
    const legend = svg.slice(svg.indexOf('data-kind="legend"'));
    for (const { opacity } of shades) {
      const strength = `fill="${heatColour(theme)}" fill-opacity="${Number(opacity.toFixed(2))}"`;
      expect(legend).toContain(strength);
    }
  }
});

test.each([400, 600, 960, 1200])('at %i px every letter is at least as large as in a font of 11 px', (width) => {
  const full = level(FULL);
  const runs = [HOLDS, [[0, 300]] as [number, number][]].map((holds, i) => ({
    run: simulate(compile(full), holds),
    label: `way ${i}: as long a line as a search has to say, which does not fit into a narrow picture at once`,
  }));
  const cells = [{ x: 0, y: 0, visits: 3 }];
  for (const options of [
    { run: runs[0].run },
    { ways: runs },
    { explored: { cellSize: 32, cells }, note: 'A search simulated much.' },
  ]) {
    const svg = renderSvg(full, { ...options, width });
    const units = Number(/viewBox="0 0 ([\d.]+)/.exec(svg)?.[1]);
    // Letters are strokes: capitals are 10 units of the stroke font high.
    const scales = [...svg.matchAll(/<path d="[^"]*" transform="translate\([^)]*\) scale\(([\d.]+)\)" fill="none"/g)].map(
      ([, s]) => Number(s),
    );
    expect(scales.length).toBeGreaterThan(5);
    // A capital has 0.725 of a font's size.
    expect((Math.min(...scales) * 10 * width) / units / 0.725).toBeGreaterThanOrEqual(10.9);
    // And nothing exceeds the picture.
    for (const [, x, scale, d] of letters(svg)) expect(x + scale * d).toBeLessThanOrEqual(units + 1);
  }
});

test('a picture without words has only the scene', () => {
  const svg = renderSvg(level(FULL), { run: play(FULL, HOLDS), width: 144, words: false });
  expect([count(svg, 'caption'), count(svg, 'presses'), count(svg, 'way')]).toEqual([0, 0, 1]);
});

test('a fan distinguishes runs that still complete the level from those that fail', () => {
  const full = level(FULL);
  const fan = [HOLDS, []].map((holds) => simulate(compile(full), holds));
  // a copy has no trajectory of its own
  const completed = { ...fan[0], trajectory: fan[0].trajectory, outcome: 'completed' as const };
  const failed = { ...fan[1], trajectory: fan[1].trajectory, outcome: 'lost' as const };
  const kinds = (svg: string) => [count(svg, 'fan-completed'), count(svg, 'fan-failed')];
  expect(kinds(renderSvg(full, { fan: [completed, failed] }))).toEqual([1, 1]);
  expect(kinds(renderSvg(full, { fan: [completed] }))).toEqual([1, 0]);
});

test('the closest approach is a line from her box to the rim of the black hole', () => {
  const file: LevelFile = {
    version: 1,
    name: 'Far',
    astronaut: { x: 0, y: 0 },
    blackHole: { x: 200, y: 0, radius: 18 },
    asteroids: [{ x: 0, y: 100, radius: 16 }],
  };
  const svg = renderSvg(level(file), { run: play(file, [], 1), nearest: 0 });
  const scale = Number(/data-kind="black-hole"[^>]*scale\(([\d.]+)\)/.exec(svg)?.[1]);
  const [, ax, ay, bx, by] = (/data-kind="gap"><path d="M([\d.]+) ([\d.]+)L([\d.]+) ([\d.]+)"/.exec(svg) ?? []).map(Number);
  // Her box is upright: its right side is 10 px from its centre.
  expect(Math.hypot(bx - ax, by - ay) / scale).toBeCloseTo(200 - 10 - 18, 1);
  // She is drawn there, too, because the run goes on.
  expect(count(svg, 'nearest')).toBe(1);
});

test('a proof: a disc or line for each object that it rests on, and what they mean', () => {
  const svg = renderSvg(level(FULL), {
    proof: {
      discs: [
        { x: 0, y: 0, radius: 30, role: 'blocked' },
        { x: 50, y: 0, radius: 250, role: 'range' },
      ],
      lines: [
        {
          points: [
            { x: 0, y: 0 },
            { x: 10, y: 0 },
            { x: 0, y: 10 },
          ],
          closed: true,
          role: 'barrier',
        },
        {
          points: [
            { x: 0, y: 0 },
            { x: 9, y: 0 },
            { x: 9, y: 9 },
          ],
          closed: true,
          role: 'reach',
        },
      ],
    },
  });
  for (const kind of ['proof-blocked', 'proof-range', 'proof-barrier', 'proof-reach'])
    expect([kind, count(svg, kind)]).toEqual([kind, 1]);
});

describe('the picture of difficulty', () => {
  const point = (sigma: number, p: number) => ({ sigma, p, low: p - 0.05, high: p + 0.05 });
  const picture = {
    title: 'How hard <Moon> is',
    subtitle: ['run'],
    curves: [{ name: 'Moon', points: [point(0, 0.9), point(100, 0.5), point(200, 0.2)], half: 100 }],
    edges: [
      { label: 'press 1', earlier: 3, later: 60 },
      { label: 'release 1', earlier: 1, later: 2 },
    ],
    limit: 60,
  };

  test('is the same text for the same input, well-formed, light and dark', () => {
    for (const ground of ['auto', 'light', 'dark'] as const) {
      const svg = drawDifficulty(picture, ground);
      expect(svg).toBe(drawDifficulty(picture, ground));
      expect(svg).toContain('<title>How hard &lt;Moon&gt; is</title>');
      expect(svg).not.toMatch(/NaN|undefined|Infinity/);
    }
  });

  test('has only finite numbers, whatever it is given', () => {
    const empty = { ...picture, edges: [], curves: [{ name: '', points: [point(0, 1)], half: null }] };
    expect(drawDifficulty(empty)).not.toMatch(/NaN|undefined|Infinity/);
  });
});
