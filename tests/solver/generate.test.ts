import { createHash } from 'node:crypto';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, DEFAULT_TERMS, findWarnings, playScript, simulate } from '../../engine/index.ts';
import {
  type Circle,
  DEFAULT_RULES,
  formatLevel,
  type Level,
  type LevelFile,
  OBJECT_LISTS,
  readLevel,
} from '../../schema/index.ts';
import {
  certify,
  createGenerator,
  findShortcuts,
  type Generated,
  type GeneratorOptions,
  varietyOf,
  verifyRun,
} from '../../solver/index.ts';
import { specOf } from '../../solver/make/generate/generator-spec.ts';
import { layOut } from '../../solver/make/generate/layout.ts';
import { createRandom } from '../../solver/random.ts';
import { expectDeep, isDeep, isHunt, itDeep, itQuick } from '../depth.ts';
import { once } from '../once.ts';

const ANY = { minerals: 'any' } as const;

// Ticks; a generator that needs more has gone wrong.
const MOST = 400_000_000;

function generate(options: GeneratorOptions, step = 5_000_000): Generated {
  const generator = createGenerator(options);
  while (generator.result === null && generator.effort.ticks < MOST) generator.advance(step);
  if (generator.result === null) throw new Error(`nothing generated: ${JSON.stringify(options)}`);
  return generator.result;
}

/** The same, in steps of the usual size; each level is generated only once. */
const generated = once((options: GeneratorOptions) => generate(options));

/** A level without ingredients, which is generated soonest of all. */
const PLAIN: GeneratorOptions = { seed: 2, size: 'medium', difficulty: 'easy', ingredients: [] };

// Seeds that finish soon; for the deep set and for a hunt seeds that take longer. The digest is the first part of the SHA-256 of the text, where it is pinned.
const WISHES: readonly (GeneratorOptions & { readonly digest: string | null })[] = [
  { ...PLAIN, digest: '7b5679183cf66eaf' },
  ...(isDeep
    ? ([
        { seed: 3, size: 'medium', difficulty: 'easy', ingredients: ['winds', 'wormholes'], digest: '775acfb1f4c10b13' },
      ] as const)
    : []),
  ...(isHunt
    ? ([
        { seed: 2, size: 'medium', difficulty: 'medium', digest: null },
        { seed: 3, size: 'small', difficulty: 'easy', digest: null },
        { seed: 1, size: 'medium', difficulty: 'easy', digest: null },
        { seed: 3, size: 'small', difficulty: 'easy', ingredients: ['winds', 'wormholes'], digest: null },
        { seed: 0, size: 'small', difficulty: 'easy', ingredients: ['winds', 'wormholes'], digest: null },
      ] as const)
    : []),
];

describe.each(WISHES)('a level generated from $seed, $size, $difficulty, $ingredients', ({ digest, ...options }) => {
  const spec = specOf(options);
  // All assertions are about the text as it would be written.
  const made = once(() => {
    const { level: of, ...claims } = generated(options);
    const text = formatLevel(of);
    const reading = readLevel(text);
    if (!reading.ok) throw new Error(reading.problems.map(({ message }) => message).join('\n'));
    return { text, again: formatLevel(reading.document.file), level: reading.level, claims };
  });

  it.skipIf(digest === null)('is the same as in earlier versions', () => {
    expect(createHash('sha256').update(made().text).digest('hex').slice(0, 16)).toBe(digest);
  });

  it.each(['precise', 'arcade'] as const)('is completed by its runs at %s, and not without pressing', (accuracy) => {
    const { level } = made();
    const scene = compile(level, accuracy);
    const [solution, all] = level.runs;
    expect(level.runs.map(({ name }) => name)).toEqual(['solution', 'all-minerals']);
    expect(simulate(scene, solution.holds).outcome).toBe('completed');
    const collected = simulate(scene, all.holds);
    expect(collected.outcome).toBe('completed');
    expect(new Set(collected.minerals.map(({ index }) => index)).size).toBe(3);
    expect(verifyRun(scene, [])).toBeNull();
  });

  it.each(['precise', 'arcade'] as const)('is as robust as it claims at %s', (accuracy) => {
    const { level, claims } = made();
    const claimed = accuracy === 'precise' ? claims.robustness : claims.arcade;
    expect(claimed.certifiedTicks).toBeGreaterThanOrEqual(spec.certifiedTicks);
    expect(claimed.p40.p).toBeGreaterThanOrEqual(spec.p40);
    const certified = certify(compile(level, accuracy), level.runs[0].holds, ANY, { limit: spec.certifiedTicks });
    expect(certified.ticks).toBe(spec.certifiedTicks);
  });

  it('is as hard as requested, and most single presses do not win', () => {
    const { level, claims } = made();
    expect(claims.grade.value).toBeGreaterThanOrEqual(spec.grade[0]);
    expect(claims.grade.value).toBeLessThanOrEqual(spec.grade[1]);
    const { onePress } = findShortcuts(compile(level, 'arcade'), ANY, { run: level.runs[0].holds, effort: 0, stride: 4 });
    // Presses were counted with a stride of three, so the share of others may be slightly larger.
    expect(onePress.count / onePress.tried).toBeLessThanOrEqual(spec.onePress + 0.01);
  });

  it('has no warnings, and lies within its size', () => {
    const { level } = made();
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

  it('has no idle object: without any one, some game ends otherwise', () => {
    const { level } = made();
    // games of the test's own: presses and pauses at random, half of them after a part of a run
    const random = createRandom(77);
    const games = Array.from({ length: 6000 }, (_, i) => {
      const { holds } = level.runs[0];
      const leave = i % 2 === 0 ? 0 : random.below(holds[holds.length - 1][1]);
      const script = holds.filter(([, release]) => release < leave).map(([from, to]) => [from, to] as const);
      for (let tick = leave; tick < leave + 1000; tick += 1 + random.below(100)) {
        const press = tick;
        tick += 1 + random.below(100);
        script.push([press, tick]);
      }
      return script;
    });
    const endingsOf = (of: Level) => {
      const simulation = createSimulation(compile(of, 'arcade'));
      return (holds: (typeof games)[number]) => {
        simulation.reset();
        playScript(simulation, holds, 1500);
        return `${simulation.ending?.outcome} ${simulation.ending?.tick}`;
      };
    };
    const whole = endingsOf(level);
    const before = games.map(whole);
    for (const list of ['novae', 'repulsors', 'aliens', 'winds', 'wormholes', 'asteroids'] as const) {
      for (const i of level[list].keys()) {
        if (list === 'asteroids' && level.asteroids.length === 1) continue;
        const without = endingsOf({ ...level, [list]: (level[list] as readonly unknown[]).filter((_, k) => k !== i) });
        expect(
          games.some((holds, game) => without(holds) !== before[game]),
          `${list} ${i}`,
        ).toBe(true);
      }
    }
  });

  it('is ready to be written, with ids on every object and a name', () => {
    const { level, text, again } = made();
    const objects = OBJECT_LISTS.flatMap((list) => level[list]);
    expect(objects.every(({ id }) => id !== null)).toBe(true);
    expect(level.name).toMatch(/^[A-Z][a-z]+ [A-Z][a-z]+$/);
    expect(again).toBe(text);
  });
});

describe('a generator', () => {
  itQuick('gives the same level however it is advanced, and other levels for other seeds', () => {
    expect(formatLevel(generate(PLAIN, 50_000).level)).toBe(formatLevel(generated(PLAIN).level));
    const texts = WISHES.map(({ digest: _, ...options }) => formatLevel(generated(options).level));
    expect(new Set(texts).size).toBe(texts.length);
  });

  itDeep('keeps no level whose runs do not hold under the asked terms', () => {
    const generator = createGenerator({ ...PLAIN, terms: { ...DEFAULT_TERMS, maxTime: 1 } });
    while (generator.effort.rejected.outOfTerms === 0 && generator.effort.ticks < MOST) generator.advance(5_000_000);
    expect(generator.effort.rejected.outOfTerms).toBe(1);
    expect(generator.result).toBeNull();
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
    const { level } = generated(PLAIN);
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
            for (const other of [...layout.asteroids, ...layout.placed.repulsors]) {
              expect(Math.hypot(mouth.x - other.x, mouth.y - other.y)).toBeGreaterThanOrEqual(radius + other.radius + 12);
            }
          }
        }
      }),
      { numRuns: 150 },
    );
    expectDeep(counts.winds).toBeGreaterThan(50);
    expectDeep(counts.wormholes).toBeGreaterThan(50);
  });
});

describe('the variety of levels', () => {
  const FILE: LevelFile = {
    version: 1,
    name: 'One',
    astronaut: { x: 100, y: 300 },
    blackHole: { x: 500, y: 180 },
    asteroids: [
      { x: 240, y: 280, radius: 16 },
      { x: 420, y: 120, radius: 32 },
    ],
    novae: [{ x: 300, y: 420, radius: 16 }],
    runs: [{ name: 'solution', holds: [[10, 90]] }],
  };
  const place = (change: (at: { x: number; y: number }) => { x: number; y: number }): LevelFile => ({
    ...FILE,
    astronaut: change(FILE.astronaut),
    blackHole: change(FILE.blackHole),
    asteroids: FILE.asteroids?.map((object) => ({ ...object, ...change(object) })),
    novae: FILE.novae?.map((object) => ({ ...object, ...change(object) })),
  });

  it('is none between a level and its moved and mirrored copies, and some between different ones', () => {
    const copies = [
      FILE,
      place(({ x, y }) => ({ x: x + 1000, y: y - 70 })),
      place(({ x, y }) => ({ x: -x, y })),
      place(({ x, y }) => ({ x, y: -y })),
    ];
    for (const copy of copies) expect(varietyOf([FILE, copy])?.mean).toBeLessThan(0.12);
    expect(varietyOf([FILE, FILE])).toEqual({ mean: 0, closest: { distance: 0, first: 0, second: 1 } });
    const other = generated(PLAIN).level;
    expect(varietyOf([FILE, other])?.mean).toBeGreaterThan(0.2);
    expect(varietyOf([FILE, other, FILE])?.closest).toEqual({ distance: 0, first: 0, second: 2 });
    expect(varietyOf([FILE])).toBeNull();
  });
});
