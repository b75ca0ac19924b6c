import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { ACCURACIES, accuracyOf } from '../../engine/index.ts';
import {
  type Diagram,
  type DiagramPoint,
  drawDiagram,
  drawTunnelling,
  layOutDiagram,
  levelDiagram,
  type RunAtSettings,
} from '../../picture/accuracy/index.ts';

/** Every tag closed in order, attributes quoted, text escaped: what any XML reader insists on. */
function expectWellFormed(svg: string): void {
  const open: string[] = [];
  let rest = svg.trim();
  while (rest !== '') {
    const text = /^[^<>]+/.exec(rest)?.[0];
    if (text !== undefined) {
      expect(text).not.toMatch(/&(?!amp;|lt;|gt;|quot;|#39;)/);
      rest = rest.slice(text.length);
      continue;
    }
    const tag = /^<(\/?)([a-z][\w-]*)((?:\s+[\w:-]+="[^"<]*")*)\s*(\/?)>/i.exec(rest);
    expect(tag, rest.slice(0, 80)).not.toBeNull();
    if (tag === null) return;
    if (tag[1] === '/') expect(open.pop()).toBe(tag[2]);
    else if (tag[4] === '') open.push(tag[2]);
    rest = rest.slice(tag[0].length);
  }
  expect(open).toEqual([]);
  expect(svg).not.toMatch(/NaN|Infinity|undefined/);
}

const size = fc.oneof(fc.constant(0), fc.double({ min: 1e-15, max: 1e4, noNaN: true }));
const point: fc.Arbitrary<DiagramPoint> = fc.record({
  error: size,
  worseError: fc.option(size),
  cost: size,
  failures: fc.integer({ min: 0, max: 3 }),
  label: fc.option(fc.string()),
  note: fc.option(fc.string()),
  time: fc.double({ min: 0, max: 4000, noNaN: true }),
  words: fc.string(),
});
const diagram: fc.Arbitrary<Diagram> = fc.record({
  title: fc.string(),
  subtitle: fc.array(fc.string(), { maxLength: 2 }),
  runs: fc.constantFrom(1, 3),
  used: fc.option(fc.string()),
  floor: size,
  lines: fc.array(
    fc.record({
      name: fc.string(),
      kind: fc.constantFrom('arcade', 'euler', 'verlet', 'rk4', 'taylor', 'peer'),
      faint: fc.boolean(),
      points: fc.array(point, { maxLength: 5 }),
    }),
    { maxLength: 4 },
  ),
});

describe('the work-precision diagram', () => {
  it('is well-formed and the same for the same data, whatever the data', () => {
    fc.assert(
      fc.property(diagram, fc.constantFrom('auto', 'light', 'dark'), (data, ground) => {
        const svg = drawDiagram(data, ground);
        expectWellFormed(svg);
        expect(drawDiagram(data, ground)).toBe(svg);
        const narrow = layOutDiagram(data, ground, 280);
        expectWellFormed(narrow.svg);
        expectWellFormed(narrow.legend ?? '');
        expect(narrow.marks.map(({ point }) => point)).toEqual(data.lines.flatMap(({ points }) => points));
        for (const { x, y } of narrow.marks) {
          expect(x).toBeGreaterThan(0);
          expect(x).toBeLessThan(narrow.width);
          expect(y).toBeGreaterThan(0);
          expect(y).toBeLessThan(narrow.height);
        }
      }),
      { numRuns: 60 },
    );
  });

  const one = (changes: Partial<DiagramPoint>): string => {
    const own = { error: 1e-3, worseError: null, cost: 5, failures: 0, label: null, note: null, time: 3, words: 'w' };
    const points = [{ ...own, ...changes }];
    return drawDiagram({
      title: 't',
      subtitle: [],
      runs: 1,
      used: 'precise',
      floor: 1e-12,
      lines: [{ name: 'rk4', kind: 'rk4', faint: false, points }],
    });
  };

  it('draws a failure hollow at the right edge instead of dropping it', () => {
    const hollow = /<path d="M([\d.]+)[^"]*" fill="none" stroke="currentColor" stroke-width="1.3"/;
    expect(one({})).not.toMatch(hollow);
    expect(Number(hollow.exec(one({ failures: 1 }))?.[1])).toBeGreaterThan(680);
  });

  it('puts a smaller error further left, and a smaller cost further down', () => {
    const at = (error: number, cost: number): DiagramPoint => ({
      ...{ error, cost, worseError: null, failures: 0, label: null, note: null, time: 3, words: '' },
    });
    const lines = [{ name: 'rk4', kind: 'rk4' as const, faint: false, points: [at(1e-9, 7), at(1e-3, 5)] }];
    const { marks } = layOutDiagram({ title: '', subtitle: [], runs: 1, used: null, floor: 1e-12, lines });
    expect(marks[0].x).toBeLessThan(marks[1].x - 100);
    expect(marks[0].y).toBeLessThan(marks[1].y);
  });

  it('rings a setting with a name, and the one in use twice, with lines to both axes', () => {
    const rings = (svg: string) => (svg.match(/<circle/g) ?? []).length - 2;
    const lines = (svg: string) => (svg.match(/stroke-dasharray="2 4"/g) ?? []).length;
    // the legend has two
    expect([rings(one({})), lines(one({}))]).toEqual([0, 0]);
    expect([rings(one({ label: 'standard' })), lines(one({ label: 'standard' }))]).toEqual([1, 0]);
    expect([rings(one({ label: 'precise' })), lines(one({ label: 'precise' }))]).toEqual([2, 2]);
  });

  it('names each point, for a viewer of pictures', () => {
    expect(one({ words: 'rk4 at 60 Hz: off by < 1 px' })).toContain('<title>rk4 at 60 Hz: off by &lt; 1 px</title>');
  });
});

describe('the diagram of a level', () => {
  const rk4 = (rate: number) => accuracyOf({ integrator: 'rk4', rate, tolerance: null, contact: 'swept' });
  const settings: RunAtSettings['settings'] = [
    { accuracy: ACCURACIES.arcade, error: 3, cost: 2, time: 5, sameVerdict: true, end: 'completes the level' },
    { accuracy: rk4(15), error: 0.5, cost: 4, time: 5, sameVerdict: true, end: 'completes the level' },
    { accuracy: rk4(30), error: 1e-3, cost: 8, time: 5, sameVerdict: true, end: 'completes the level' },
    { accuracy: ACCURACIES.standard, error: 1e-6, cost: 16, time: 5, sameVerdict: true, end: 'completes the level' },
    { accuracy: rk4(120), error: 1e-5, cost: 32, time: 5, sameVerdict: true, end: 'completes the level' },
    { accuracy: ACCURACIES.fast, error: 7, cost: 1, time: 2, sameVerdict: false, end: 'collided with nova 1 at 2.00 s' },
  ];
  const about = { title: 't', subtitle: [], used: 'standard', named: Object.keys(ACCURACIES) };
  const run = (name: string, more: Partial<RunAtSettings> = {}): RunAtSettings => ({ name, knownTo: 1e-20, settings, ...more });
  const costs = (points: Iterable<DiagramPoint>) => [...points].map(({ cost }) => cost);

  it('marks what nothing cheaper is as exact as, and the best of each integrator; another outcome is neither', () => {
    const { best } = levelDiagram({ ...about, runs: [run('a')] });
    expect(costs(best?.front ?? [])).toEqual([2, 4, 8, 16]);
    // the cheapest that is good enough; of arcade, none is
    expect(costs(best?.ofFamilies ?? [])).toEqual([2, 8]);
  });

  it('says of a point what it is, how exactly that is known, what it costs and how the run ends', () => {
    const words = (runs: readonly RunAtSettings[], each = false) =>
      levelDiagram({ ...about, runs, each }).lines.flatMap(({ points }) => points.map((point) => point.words));
    expect(words([run('a')])[3]).toBe(
      'rk4 at 60 Hz, swept contacts (standard): off by 1.0e-6 px, known to 1.0e-20 px; ' +
        '16 µs a second of play, 0.0016 % of a frame at 60 Hz, 12,500 runs a second; completes the level.',
    );
    expect(words([run('a')])[5]).toMatch(/another outcome: collided with nova 1 at 2\.00 s\.$/);
    expect(words([run('a', { knownTo: 1e-4 })])[3]).toContain('off by < 1.0e-4 px');
    expect(words([run('a', { knownTo: null })])[3]).toContain('off by (1.0e-6) px, from a reference that no second one confirms');
    expect(words([run('a'), run('b', { knownTo: null })])[3]).toMatch(
      /off by \(1\.0e-6\) px in the median of 2 runs, from a reference that no second/,
    );
    expect(words([run('a'), run('b')], true).map((text) => text.slice(0, 3))).toEqual([
      ...Array(6).fill('a: '),
      ...Array(6).fill('b: '),
    ]);
  });

  it('has all runs in one point, or a point for each; one that could not be played at a setting takes its point away', () => {
    const slow = settings.map((one) => ({ ...one, cost: 3 * one.cost, error: 3 * one.error, time: 15 }));
    const both = [run('a'), run('b', { settings: slow.slice(0, 4) })];
    const points = levelDiagram({ ...about, runs: both }).lines.flatMap((line) => line.points);
    expect(points.map(({ cost }) => cost)).toEqual([5, 10, 20, 40]);
    for (const [i, factor] of [3, 0.5, 1e-3, 1e-6].entries()) expect(points[i].error).toBeCloseTo(2 * factor, 12);
    const each = levelDiagram({ ...about, runs: both, each: true });
    expect(each.lines.flatMap((line) => line.points)).toHaveLength(10);
    expect([each.runs, each.best]).toEqual([1, undefined]);
  });

  it('has an axis under the runs with another outcome', () => {
    const { svg, marks } = layOutDiagram(levelDiagram({ ...about, runs: [run('a')] }), 'dark', 300);
    const failed = marks.filter(({ point }) => point.failures > 0);
    expect(failed).toHaveLength(1);
    for (const { x } of marks) expect(x > 230).toBe(x === failed[0].x);
    expect(svg.length).toBeGreaterThan(1000);
  });
});

describe('the tunnelling curve', () => {
  it('is well-formed, with nothing missed as well', () => {
    for (const missed of [0, 0.01, 0.9]) {
      const svg = drawTunnelling({
        title: 'a < b & "c"',
        subtitle: 's',
        sweptNote: 'none',
        curves: [
          { radius: 0.5, points: [[50, 0] as const, [1000, missed] as const] },
          { radius: 16, points: [[50, 0] as const, [1000, missed / 2] as const] },
        ],
      });
      expectWellFormed(svg);
    }
  });
});
