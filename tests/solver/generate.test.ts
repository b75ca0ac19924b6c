import { createHash } from 'node:crypto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, findWarnings, simulate } from '../../engine/index.ts';
import { type Circle, DEFAULT_RULES, formatLevel, OBJECT_LISTS, readLevel } from '../../schema/index.ts';
import { specOf } from '../../solver/generate/generator-spec.ts';
import { layOut } from '../../solver/generate/layout.ts';
import { certify, createGenerator, findShortcuts, type Generated, type GeneratorOptions, verifyRun } from '../../solver/index.ts';
import { createRandom } from '../../solver/random.ts';

const ANY = { minerals: 'any' } as const;

// Ticks; a generator that needs more has gone wrong.
const MOST = 400_000_000;

function generate(options: GeneratorOptions, step = 5_000_000): Generated {
  const generator = createGenerator(options);
  while (generator.result === null && generator.effort.ticks < MOST) generator.advance(step);
  if (generator.result === null) throw new Error(`nothing generated: ${JSON.stringify(options)}`);
  return generator.result;
}

// Seeds that finish soon.
const WISHES: readonly GeneratorOptions[] = [
  { seed: 3, size: 'small', difficulty: 'easy' },
  { seed: 1, size: 'medium', difficulty: 'easy' },
  { seed: 2, size: 'medium', difficulty: 'medium' },
  { seed: 0, size: 'small', difficulty: 'easy', ingredients: ['winds', 'wormholes'] },
];

/** A level without ingredients, which is generated soonest of all. */
const PLAIN: GeneratorOptions = { seed: 2, size: 'medium', difficulty: 'easy', ingredients: [] };

const LEVELS = WISHES.map((options) => ({ options, generated: generate(options) }));

describe.each(LEVELS)('a level generated from $options', ({ options, generated }) => {
  const spec = specOf(options);
  // All assertions are about the text as it would be written.
  const text = formatLevel(generated.level);
  const reading = readLevel(text);
  if (!reading.ok) throw new Error(reading.problems.map(({ message }) => message).join('\n'));
  const { level } = reading;
  const [solution, all] = level.runs;

  it.each(['precise', 'arcade'] as const)('is completed by its runs at %s, and not without pressing', (accuracy) => {
    const scene = compile(level, accuracy);
    expect(level.runs.map(({ name }) => name)).toEqual(['solution', 'all-minerals']);
    expect(simulate(scene, solution.holds).outcome).toBe('completed');
    const collected = simulate(scene, all.holds);
    expect(collected.outcome).toBe('completed');
    expect(new Set(collected.minerals.map(({ index }) => index)).size).toBe(3);
    expect(verifyRun(scene, [])).toBeNull();
  });

  it.each(['precise', 'arcade'] as const)('is as robust as it claims at %s', (accuracy) => {
    const claimed = accuracy === 'precise' ? generated.robustness : generated.arcade;
    expect(claimed.certifiedTicks).toBeGreaterThanOrEqual(spec.certifiedTicks);
    expect(claimed.p40.p).toBeGreaterThanOrEqual(spec.p40);
    const certified = certify(compile(level, accuracy), solution.holds, ANY, { limit: spec.certifiedTicks });
    expect(certified.ticks).toBe(spec.certifiedTicks);
  });

  it('is as hard as requested, and most single presses do not win', () => {
    expect(generated.grade.value).toBeGreaterThanOrEqual(spec.grade[0]);
    expect(generated.grade.value).toBeLessThanOrEqual(spec.grade[1]);
    const { onePress } = findShortcuts(compile(level, 'arcade'), ANY, { run: solution.holds, effort: 0, stride: 2 });
    // Presses were counted with a stride of three, so the share of others may be slightly larger.
    expect(onePress.count / onePress.tried).toBeLessThanOrEqual(spec.onePress + 0.01);
  });

  it('has no warnings, and lies within its size', () => {
    const scene = compile(level);
    const runs = level.runs.map(({ holds }) => simulate(scene, holds));
    expect(findWarnings(level, runs)).toEqual([]);
    const mouths = level.wormholes.flatMap(({ x, y, toX, toY, radius }) => [
      { x, y, radius },
      { x: toX, y: toY, radius },
    ]);
    const bodies: Pick<Circle, 'x' | 'y' | 'radius'>[] = [
      level.blackHole,
      ...level.asteroids,
      ...level.novae,
      ...level.aliens,
      ...mouths,
    ];
    for (const { x, y, radius } of bodies) {
      expect(Math.min(x, y) - radius).toBeGreaterThanOrEqual(20);
      expect(x + radius).toBeLessThanOrEqual(spec.width - 20);
      expect(y + radius).toBeLessThanOrEqual(spec.height - 20);
    }
    for (const [i, a] of bodies.entries()) {
      for (const b of bodies.slice(i + 1)) {
        expect(Math.hypot(a.x - b.x, a.y - b.y)).toBeGreaterThanOrEqual(a.radius + b.radius + 12);
      }
    }
  });

  it('is ready to be written, with ids on every object and a name', () => {
    const objects = OBJECT_LISTS.flatMap((list) => level[list]);
    expect(objects.every(({ id }) => id !== null)).toBe(true);
    expect(level.name).toMatch(/^[A-Z][a-z]+ [A-Z][a-z]+$/);
    expect(formatLevel(reading.document.file)).toBe(text);
  });
});

describe('a generator', () => {
  const plain = generate(PLAIN);

  it('gives the same level however it is advanced, and other levels for other seeds', () => {
    const text = formatLevel(plain.level);
    expect(formatLevel(generate(PLAIN, 50_000).level)).toBe(text);
    const texts = [text, ...LEVELS.map(({ generated }) => formatLevel(generated.level))];
    expect(new Set(texts).size).toBe(texts.length);
  });

  it('gives the same level for a seed as before winds and wormholes existed', () => {
    const digests = LEVELS.slice(0, 3).map(({ generated }) =>
      createHash('sha256').update(formatLevel(generated.level)).digest('hex').slice(0, 16),
    );
    expect(digests).toEqual(['d1075594f33b9a0f', '10fe3da5714ec28c', 'b5d189d10a00a53e']);
  });

  it('refuses impossible options', () => {
    expect(() => createGenerator({ seed: 1, size: { width: 200, height: 600 } })).toThrow(
      'width: expected 360 to 4000 px, found 200',
    );
    expect(() => createGenerator({ seed: 1, difficulty: 11 })).toThrow('difficulty: expected a grade from 1 to 10');
    expect(() => createGenerator({ seed: 1, difficulty: Number.NaN })).toThrow('found NaN');
  });

  it('requires less robustness the harder a level should be', () => {
    fc.assert(
      fc.property(fc.integer({ min: 10, max: 100 }), fc.integer({ min: 10, max: 100 }), (a, b) => {
        const [easy, hard] = [Math.min(a, b), Math.max(a, b)].map((grade) => specOf({ seed: 0, difficulty: grade / 10 }));
        expect(hard.p40).toBeLessThanOrEqual(easy.p40);
        expect(hard.onePress).toBeLessThanOrEqual(easy.onePress);
        expect(hard.certifiedTicks).toBeLessThanOrEqual(easy.certifiedTicks);
        expect(hard.grade[0]).toBeGreaterThanOrEqual(easy.grade[0]);
        expect(hard.certifiedTicks).toBeGreaterThan(0);
      }),
    );
  });

  it('uses only the allowed ingredients', () => {
    const { level } = plain;
    expect(level.aliens).toBeUndefined();
    expect(level.repulsors).toBeUndefined();
    expect(level.recoil).toBeUndefined();
    expect(level.winds).toBeUndefined();
    expect(level.wormholes).toBeUndefined();
    expect(level.asteroids?.some(({ hot }) => hot)).toBe(false);
  });

  it('places winds and wormholes on request: in play, and clear of the start and of what they would hide', () => {
    const counts = { winds: 0, wormholes: 0 };
    fc.assert(
      fc.property(fc.nat(2 ** 32 - 1), fc.constantFrom('easy', 'medium', 'hard'), (seed, difficulty) => {
        const spec = specOf({ seed, difficulty, ingredients: ['winds', 'wormholes', 'repulsors'] });
        const layout = layOut(createRandom(seed), spec);
        if (layout === null) return;
        counts.winds += layout.placed.winds.length;
        counts.wormholes += layout.placed.wormholes.length;
        for (const { x, y, radius, ax, ay } of layout.placed.winds) {
          expect(Math.hypot(x - layout.start.x, y - layout.start.y)).toBeGreaterThan(radius + 32);
          const strength = Math.hypot(ax, ay);
          expect(strength).toBeGreaterThanOrEqual(10);
          expect(strength).toBeLessThan(DEFAULT_RULES.pull);
        }
        for (const { x, y, toX, toY, radius } of layout.placed.wormholes) {
          expect(Math.hypot(toX - x, toY - y)).toBeGreaterThanOrEqual(160);
          for (const mouth of [
            { x, y },
            { x: toX, y: toY },
          ]) {
            expect(Math.hypot(mouth.x - layout.start.x, mouth.y - layout.start.y)).toBeGreaterThan(radius + 32);
            for (const other of [...layout.asteroids, ...layout.repulsors]) {
              expect(Math.hypot(mouth.x - other.x, mouth.y - other.y)).toBeGreaterThanOrEqual(radius + other.radius + 12);
            }
          }
        }
      }),
      { numRuns: 300 },
    );
    expect(counts.winds).toBeGreaterThan(100);
    expect(counts.wormholes).toBeGreaterThan(100);
  });
});
