import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { compile, simulate } from '../../engine/index.ts';
import { apart, gauss, type Method, NotCovered, type Played, play, taylor } from '../../engine/work-precision/reference/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { isDeep } from '../depth.ts';
import { type PlainLevel, plainLevel } from '../engine/plain-level.ts';
import { pack } from '../levels/shipped-pack.ts';
import { declareMissing } from '../missing.ts';
import { propertySettings } from '../property-settings.ts';
import { mixedScene } from '../scenes/mixed-scene.ts';
import {
  continuousReferences,
  hardReferences,
  hasContinuousReferences,
  hasHardReferences,
  NO_REFERENCES,
} from '../truth/references.ts';

type Dd = Played['end']['time'];

const toNumber = ({ hi, lo }: Dd): number => hi + lo;

const METHODS: readonly [string, Method][] = [
  ['Gauss collocation', gauss],
  ['Taylor series', taylor],
];

const from = (method: Method, level: Level, holds: readonly Hold[], maxTicks: number): Played =>
  play(level, holds, { method, maxTicks, every: 60, nudge: [0, 0, 0, 0], mostWork: 20_000_000 });

/** A double-double as a whole number of 1e-36, for exact arithmetic. */
function exactly({ hi, lo }: Dd): bigint {
  const whole = (value: number): bigint => {
    // value = mantissa * 2^exponent
    let exponent = 0;
    let mantissa = value;
    while (!Number.isInteger(mantissa)) {
      mantissa *= 2;
      exponent++;
    }
    return (BigInt(mantissa) * 10n ** 36n) / 2n ** BigInt(exponent);
  };
  return whole(hi) + whole(lo);
}

const ONE = 10n ** 36n;
const product = (...factors: bigint[]): bigint => factors.reduce((a, b) => (a * b) / ONE);

/** What the files of a folder import. */
function importsOf(folder: URL): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory()
      ? importsOf(new URL(`${entry.name}/`, folder))
      : [...readFileSync(new URL(entry.name, folder), 'utf8').matchAll(/from '([^']+)'/g)].map(
          ([, path]) => new URL(path, new URL(entry.name, folder)).href,
        ),
  );
}

describe('the references with 32 digits', () => {
  const folder = new URL('../../engine/work-precision/reference/', import.meta.url);

  it('share nothing with the engine', () => {
    const imports = importsOf(folder);
    expect(imports.length).toBeGreaterThan(20);
    const schema = new URL('../../schema/basics/index.ts', import.meta.url).href;
    expect(imports.filter((path) => !path.startsWith(folder.href) && path !== schema)).toEqual([]);
  });

  it('share neither the integrator nor the location of events with each other', () => {
    for (const [own, other] of [
      ['gauss', 'taylor'],
      ['taylor', 'gauss'],
    ]) {
      const imports = importsOf(new URL(`${own}/`, folder));
      expect(imports.length).toBeGreaterThan(4);
      expect(imports.filter((path) => path.startsWith(`${folder.href}${other}/`))).toEqual([]);
    }
  });
});

describe.each(METHODS)('the reference by %s', (_, method) => {
  it('falls in a wind as the closed form says, to 28 digits', () => {
    const level = {
      ...plainLevel({ range: 1000, asteroids: [{ x: 500, y: 0, radius: 16 }] }),
      winds: [{ id: null, x: 0, y: 0, radius: 400, ax: 7, ay: -3 }],
    };
    const { end, outcome } = from(method, level, [], 70);
    expect(outcome).toBe('timeout');
    const t = (ONE * 70n) / 60n;
    expect(Number(exactly(end.at.x) - product(7n * ONE, t, t) / 2n) / 1e36).toBeCloseTo(0, 27);
    expect(Number(exactly(end.velocity.y) + 3n * t) / 1e36).toBeCloseTo(0, 27);
  });

  it('keeps energy and angular momentum of an orbit to 24 digits', () => {
    const level = plainLevel({ range: 250, asteroids: [{ x: 100, y: 0, radius: 16 }], astronaut: { vy: 41 } });
    const { end } = from(method, level, [[0, 1200]], 1200);
    const [x, y, vx, vy] = [end.at.x, end.at.y, end.velocity.x, end.velocity.y].map(exactly);
    const dx = x - 100n * ONE;
    const momentum = product(dx, vy) - product(y, vx);
    expect(Math.abs(Number(momentum + 4100n * ONE) / 1e36)).toBeLessThan(1e-24);
    // v2 / 2 + 39 (d - d2 / 500), with d from its square by Newton's method
    const d2 = product(dx, dx) + product(y, y);
    let d = BigInt(Math.round(Math.sqrt(Number(d2) / 1e36) * 1e15)) * 10n ** 21n;
    for (let n = 0; n < 3; n++) d = (d + (d2 * ONE) / d) / 2n;
    const energy = (product(vx, vx) + product(vy, vy)) / 2n + 39n * (d - d2 / 500n);
    const atStart = (1681n * ONE) / 2n + 39n * (100n * ONE - (10_000n * ONE) / 500n);
    expect(Math.abs(Number(energy - atStart) / 1e36)).toBeLessThan(1e-24);
  });

  it('slides on a rim between a pull inwards and a push outwards, as fast as she was', () => {
    const level = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      astronaut: { x: 50, vy: 3 },
      repulsors: [{ x: 0, y: 0, radius: 50 }],
    });
    const { end, slides } = from(method, level, [[0, 600]], 600);
    expect([...slides]).toEqual(['field']);
    expect(toNumber(end.at.x)).toBeCloseTo(50 * Math.cos(0.6), 13);
    expect(toNumber(end.at.y)).toBeCloseTo(50 * Math.sin(0.6), 13);
  });

  it('decides at the start: what overlaps, then overlapping aliens, then the press and what it turns her into, then touches', () => {
    const endOf = (parts: PlainLevel, holds: Hold[] = [[0, 15]]) => {
      const { outcome, with: touched, story } = from(method, plainLevel(parts), holds, 15);
      return [touched?.kind ?? outcome, ...story].join(', ');
    };
    const asteroids = [{ x: -50, y: 20, radius: 16 }];
    const one = { x: -40, y: 0, radius: 30 };
    const touched = { astronaut: { vx: -20 }, asteroids, aliens: [one, { x: -20, y: -2, radius: 10 }] };
    expect(endOf(touched)).toBe('timeout, explosion 0 1, press');
    expect(endOf(touched, [])).toBe('timeout, explosion 0 1');
    expect(endOf({ ...touched, aliens: [one] })).toBe('alien, press');
    // the press turns her into one of two that touch
    const two = [
      { x: 0, y: 67, radius: 50 },
      { x: -60, y: 67, radius: 10 },
    ];
    expect(endOf({ asteroids: [{ x: -80, y: 60, radius: 5 }], aliens: two })).toBe('alien, press');
    // of two equally near asteroids the gun turns her to the first, though she moves away from it
    const equal = [
      { x: 160, y: -120, radius: 20 },
      { x: -120, y: -160, radius: 20 },
    ];
    expect(endOf({ astronaut: { vx: -4, vy: 3 }, asteroids: equal, novae: [{ x: 0, y: -27, radius: 10 }] })).toBe('nova, press');
  });

  it('does not touch what she grazes exactly, with nothing to spare', () => {
    const hot = plainLevel({ astronaut: { vy: 40 }, asteroids: [{ x: 26, y: 1, radius: 16, hot: true }], rules: { pull: 0 } });
    expect(from(method, hot, [[1, 30]], 30).outcome).toBe('timeout');
    const mouth = plainLevel({
      astronaut: { vx: 5 },
      asteroids: [{ x: -32, y: 0, radius: 20 }],
      wormholes: [{ x: 0, y: 50, toX: 100, toY: 50, radius: 50 }],
      range: 200,
    });
    expect(from(method, mouth, [[0, 30]], 30).story).toEqual(['press']);
  });

  it('passes the centre along a diagonal at both speed limits, and does not know which axis a wind across lets go there', () => {
    const level = (ax: number, ay: number) =>
      plainLevel({
        range: 250,
        astronaut: { x: 100, y: 100, vx: -20, vy: -20 },
        asteroids: [{ x: 0, y: 0, radius: 16 }],
        winds: [{ x: 0, y: 0, radius: 1e4, ax, ay }],
        rules: { speedLimit: 20 },
      });
    const { story, end } = from(method, level(0, 0), [[0, 360]], 360);
    expect(story).toEqual(['press', 'limit 0', 'limit 1', 'centre 0', 'limit 0', 'limit 1']);
    // a second after the centre: distance 250 - a e^(k t) - b e^(-k t)
    const k = Math.sqrt(39 / 250);
    const faster = (20 * Math.SQRT2) / k;
    const distance = 250 - ((250 - faster) * Math.exp(k) + (250 + faster) * Math.exp(-k)) / 2;
    expect(toNumber(end.at.x)).toBeCloseTo(-distance / Math.SQRT2, 10);
    expect(toNumber(end.at.y)).toBe(toNumber(end.at.x));
    expect(() => from(method, level(5, -5), [[0, 360]], 360)).toThrow(NotCovered);
  });

  it('says that a dip of 1e-9 px into a field makes 450,000 times as much of a shift, so that precise is off by rounding alone', () => {
    const level = plainLevel({ astronaut: { vy: 100 }, repulsors: [{ x: 48 - 1e-9, y: 200, radius: 48 }] });
    const endOf = (nudge: number) =>
      play(level, [], { method, maxTicks: 600, every: 60, nudge: [nudge, 0, 0, 0], mostWork: 20_000_000 }).end.at;
    const off = (x: number, y: number) => Math.hypot(x - toNumber(endOf(0).x), y - toNumber(endOf(0).y));
    const shifted = endOf(1e-14);
    const grown = off(toNumber(shifted.x), toNumber(shifted.y)) / 1e-14;
    expect(grown).toBeGreaterThan(4e5);
    const { final } = simulate(compile(level), [], { maxTime: 10 });
    // half a unit in the last place of 48
    expect(off(final.x, final.y)).toBeLessThan(grown * 2 ** -48);
  });

  it('says where it does not know how to go on: along the very range of an asteroid as she leaves that of another', () => {
    const asteroids = [
      { x: 0, y: -50, radius: 20 },
      { x: 40, y: -30, radius: 20 },
    ];
    const level = plainLevel({ astronaut: { vx: 3, vy: 4 }, asteroids, range: 50 });
    expect(() => from(method, level, [], 15)).toThrow(NotCovered);
  });

  it('says where it does not know how to go on: at rest in the centre of the target and in a field', () => {
    const level = plainLevel({
      range: 400,
      asteroids: [{ x: 0, y: 0, radius: 16 }],
      repulsors: [{ x: 20, y: 0, radius: 30 }],
    });
    expect(() => from(method, level, [[0, 60]], 60)).toThrow(NotCovered);
  });
});

/** Of each shipped level its first run; in the deep set all of them. */
const RUNS = pack.flatMap(({ slug, level }) =>
  level.runs.slice(0, isDeep ? undefined : 1).map(({ name, holds }) => [`${slug}, ${name}`, level, holds] as const),
);

describe('both references', () => {
  it.each(RUNS)('agree to 24 digits on %s', (_, level, holds) => {
    const [a, b] = METHODS.map(([, method]) => from(method, level, holds, 3600));
    expect([a.outcome, a.with, a.story]).toEqual([b.outcome, b.with, b.story]);
    expect(apart(a, b)).toBeLessThan(1e-22);
    expect(Math.abs(a.end.time.hi - b.end.time.hi + (a.end.time.lo - b.end.time.lo))).toBeLessThan(1e-24);
  });

  const SEEDS = Math.round((isDeep ? 60 : 6) * propertySettings(process.env).runs);

  it('agree where all effects and rules meet', () => {
    let compared = 0;
    for (let seed = 0; seed < SEEDS; seed++) {
      const { level, holds, maxTime } = mixedScene(seed);
      const [a, b] = METHODS.map(([, method]) => {
        try {
          return from(method, level, holds, Math.round(60 * maxTime));
        } catch (error) {
          if (error instanceof NotCovered) return null;
          throw error;
        }
      });
      if (a === null || b === null) continue;
      compared++;
      expect([seed, a.outcome, a.with]).toEqual([seed, b.outcome, b.with]);
      expect(apart(a, b)).toBeLessThan(1e-18);
    }
    expect(compared).toBeGreaterThan(0.9 * SEEDS);
  });
});

const suite = 'the references with 32 digits, against references made elsewhere';

if (!hasContinuousReferences || !hasHardReferences) declareMissing(suite, NO_REFERENCES);
else {
  describe.each(METHODS)(`${suite}: %s`, (_, method) => {
    // each hard case, and a sample of the others
    const cases = [...hardReferences(), ...continuousReferences().filter((_, i) => i % 9 === 0)];

    // what brackets events is ten times as slow
    const own = isDeep || method === taylor ? cases : cases.filter((_, i) => i % 5 === 0);

    it.each(own)('$id: the same to the last digit of a double', ({ level, reference }) => {
      const played = from(method, level, reference.holds, 3600);
      expect([played.outcome, played.with]).toEqual([reference.outcome, reference.with]);
      expect(played.minerals.map(({ index }) => index)).toEqual(reference.minerals.map(({ index }) => index));
      const { at, velocity, time } = played.end;
      const { final } = reference;
      const far = Math.max(1, Math.abs(final.x), Math.abs(final.y));
      expect(Math.abs(toNumber(at.x) - final.x)).toBeLessThan(1e-14 * far);
      expect(Math.abs(toNumber(at.y) - final.y)).toBeLessThan(1e-14 * far);
      expect(Math.abs(toNumber(velocity.x) - final.vx)).toBeLessThan(1e-13);
      expect(Math.abs(toNumber(velocity.y) - final.vy)).toBeLessThan(1e-13);
      expect(Math.abs(toNumber(time) - reference.time)).toBeLessThan(1e-14 * Math.max(1, reference.time));
    });
  });
}
