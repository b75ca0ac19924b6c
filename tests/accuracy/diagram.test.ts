import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Diagram, type DiagramPoint, drawDiagram, drawTunnelling } from '../../picture/accuracy/index.ts';

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
});
const diagram: fc.Arbitrary<Diagram> = fc.record({
  title: fc.string(),
  subtitle: fc.array(fc.string(), { maxLength: 2 }),
  runs: fc.constant(3),
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
      }),
      { numRuns: 60 },
    );
  });

  const one = (changes: Partial<DiagramPoint>): string => {
    const points = [{ error: 1e-3, worseError: null, cost: 5, failures: 0, label: null, note: null, ...changes }];
    return drawDiagram({
      title: 't',
      subtitle: [],
      runs: 1,
      floor: 1e-12,
      lines: [{ name: 'rk4', kind: 'rk4', faint: false, points }],
    });
  };

  it('draws a failure hollow at the right edge instead of dropping it', () => {
    const hollow = /<path d="M([\d.]+)[^"]*" fill="none" stroke="currentColor" stroke-width="1.3"/;
    expect(one({})).not.toMatch(hollow);
    expect(Number(hollow.exec(one({ failures: 1 }))?.[1])).toBeGreaterThan(680);
  });

  it('puts a smaller error further left', () => {
    const mark = /<path d="M([\d.]+)[^"]*Z" fill="currentColor"/;
    const place = (error: number) => Number(mark.exec(one({ error }))?.[1]);
    expect(place(1e-9)).toBeLessThan(place(1e-3));
  });

  it('rings a setting with a name', () => {
    expect(one({})).not.toContain('<circle');
    expect(one({ label: 'standard' })).toContain('<circle');
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
