import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { createEditedLevel, objectsOf, radiusOf } from '../../editor/core/document/index.ts';
import { createProver, type LiveProof } from '../../editor/core/proof/index.ts';
import { fieldsOf, type Subject, sharedFields, valueOfObjects } from '../../editor/features/inspector/fields.ts';
import { nearestPass, runFactsOf } from '../../editor/features/inspector/run-facts.ts';
import { targetedIn } from '../../editor/features/inspector/stretches.ts';
import { ACCURACIES, compile, DEFAULT_TERMS, STATE_SIZE, simulate, TICK } from '../../engine/index.ts';
import {
  fieldsOf as fieldsOfKind,
  isRequired,
  KINDS,
  type LevelFile,
  LIMITS,
  levelSchema,
  OBJECT_KINDS,
  OBJECT_LISTS,
  type ObjectKind,
  readLevel,
  resolveLevel,
  withIds,
} from '../../schema/index.ts';
import { arbitraryFile } from './arbitrary-file.ts';

const levels = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'levels');
const SHIPPED: readonly LevelFile[] = readdirSync(levels)
  .filter((name) => name.endsWith('.level.json'))
  .map((name) => {
    const reading = readLevel(readFileSync(join(levels, name), 'utf8'));
    if (!reading.ok) throw new Error(`${name} can not be read`);
    return reading.document.file;
  });

const provenFile = (file: LevelFile): LiveProof =>
  createProver(() => 0).prove({ file: createEditedLevel(file).file(), run: null, terms: DEFAULT_TERMS });

const SUBJECTS: readonly Subject[] = ['level', ...OBJECT_KINDS];

/** The required fields of a kind. */
const leastOf = (kind: ObjectKind) =>
  Object.fromEntries(fieldsOfKind(kind).flatMap(([name, field]) => (isRequired(field) ? [[name, 1]] : [])));

/** A level in which one property of one subject has a value. */
function levelWith(subject: Subject, key: string, value: unknown): unknown {
  const base = { version: 1, name: 'level', astronaut: { x: 0, y: 0 }, blackHole: { x: 0, y: 0 } };
  if (subject === 'level') return { ...base, [key]: value };
  const object = { ...leastOf(subject), [key]: value };
  const { list } = KINDS[subject];
  return { ...base, ...(list === null ? { [subject]: object } : { [list]: [object] }) };
}

describe('fields of the inspector', () => {
  it('have the limits of the schema: the ends are valid, values beyond are not', () => {
    for (const subject of SUBJECTS) {
      for (const { key, type, least, most } of fieldsOf(subject).fields) {
        const accepts = (value: unknown) => levelSchema.safeParse(levelWith(subject, key, value)).success;
        if (type === 'number') {
          expect([subject, key, accepts(least), accepts(most)]).toEqual([subject, key, true, true]);
          expect([subject, key, accepts(least - Math.abs(least) / 2 - 1), accepts(most * 2)]).toEqual([
            subject,
            key,
            false,
            false,
          ]);
        } else if (type === 'text') {
          expect([key, accepts('a'.repeat(most)), accepts('a'.repeat(most + 1))]).toEqual([key, true, false]);
        } else expect([key, accepts(true), accepts('yes')]).toEqual([key, true, false]);
      }
    }
  });

  it('are all settable properties, and no others', () => {
    const keys = Object.fromEntries(SUBJECTS.map((subject) => [subject, fieldsOf(subject).fields.map(({ key }) => key)]));
    expect(keys).toEqual({
      ...keys,
      level: ['name', 'description', 'range', 'recoil'],
      astronaut: ['x', 'y', 'vx', 'vy'],
      blackHole: ['x', 'y', 'radius'],
      asteroid: ['x', 'y', 'radius', 'hot'],
      nova: ['x', 'y', 'radius'],
      repulsor: ['x', 'y', 'radius'],
      alien: ['x', 'y', 'radius'],
      mineral: ['x', 'y', 'radius'],
    });
    for (const subject of SUBJECTS) for (const { about } of fieldsOf(subject).fields) expect(about).not.toBe('');
  });

  it('know the default of an optional property; a required one has none', () => {
    for (const subject of SUBJECTS) {
      for (const { key, fallback } of fieldsOf(subject).fields) {
        const canBeLeftOut = levelSchema.safeParse(levelWith(subject, key, undefined)).success;
        expect([subject, key, fallback !== undefined]).toEqual([subject, key, canBeLeftOut]);
        if (!canBeLeftOut) continue;
        // with the default written or omitted, it is the same level
        const written = resolveLevel(levelWith(subject, key, fallback) as LevelFile);
        expect(resolveLevel(levelWith(subject, key, undefined) as LevelFile)).toEqual(written);
      }
    }
  });

  it('of several kinds are those that all of them have', () => {
    expect(sharedFields(['asteroid', 'mineral']).map(({ key }) => key)).toEqual(['x', 'y', 'radius']);
    expect(sharedFields(['astronaut', 'mineral']).map(({ key }) => key)).toEqual(['x', 'y']);
    // an asteroid has no default to reset to
    expect(sharedFields(['asteroid', 'mineral']).find(({ key }) => key === 'radius')?.fallback).toBeUndefined();
    expect(sharedFields(['mineral', 'mineral']).find(({ key }) => key === 'radius')?.fallback).toBe(7);
  });

  it('show the common value of all selected objects, or null if they differ', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const level = createEditedLevel(file).file();
        const objects = [...objectsOf(level).values()].filter(({ kind }) => kind !== 'astronaut');
        const resolved = resolveLevel(level);
        const radii = new Set([
          resolved.blackHole.radius,
          ...OBJECT_LISTS.flatMap((list) => resolved[list].map(({ radius }) => radius)),
        ]);
        const [radius] = sharedFields(['mineral']).filter(({ key }) => key === 'radius');
        expect(valueOfObjects(objects, radius).value).toBe(radii.size === 1 ? [...radii][0] : null);
      }),
    );
  });
});

describe('the effect of the run on an object', () => {
  it('gives no smaller distance to a hazard than the clearance, and for one hazard the same, up to the motion of a tick', () => {
    let checked = 0;
    for (const file of SHIPPED) {
      const proof = provenFile(file);
      const { clearance } = simulate(compile(proof.level), proof.run.holds);
      if (clearance === null) continue;
      const hazards = [...objectsOf(proof.file).values()].filter(
        ({ kind, object }) =>
          kind === 'nova' || kind === 'alien' || (kind === 'asteroid' && 'hot' in object && object.hot === true),
      );
      const gaps = hazards.map(
        (found) => nearestPass(proof, found, radiusOf(found) ?? 0, 'box')?.gap ?? Number.POSITIVE_INFINITY,
      );
      const fastest = Math.max(...proof.margins.speed);
      expect(Math.min(...gaps)).toBeGreaterThanOrEqual(clearance.distance - 1e-6);
      expect(Math.min(...gaps)).toBeLessThanOrEqual(clearance.distance + fastest * TICK);
      checked++;
    }
    expect(checked).toBeGreaterThan(5);
  });

  it('lists when asteroids are targets, which in total takes as long as the gun is held', () => {
    for (const file of SHIPPED) {
      const { full, level, run } = provenFile(file);
      const pulled = level.asteroids.flatMap((_, i) => targetedIn(full?.events ?? [], i, run.time));
      const held = run.holds.reduce(
        (sum, [press, release]) => sum + Math.max(0, Math.min(release * TICK, run.time) - press * TICK),
        0,
      );
      expect(pulled.reduce((sum, { from, to }) => sum + to - from, 0)).toBeCloseTo(held, 6);
    }
  });

  it('says for every mineral whether it is collected', () => {
    for (const file of SHIPPED) {
      const proof = provenFile(file);
      for (const found of objectsOf(proof.file).values()) {
        if (found.kind !== 'mineral') continue;
        const [taken] = runFactsOf(proof, found, radiusOf(found));
        const isTaken = proof.full?.minerals.some(({ index }) => index === found.index);
        expect(taken.tone).toBe(isTaken ? 'good' : 'warn');
      }
    }
  });

  it('says at which tick of the run the black hole completes it', () => {
    for (const file of SHIPPED) {
      const proof = provenFile(file);
      const hole = [...objectsOf(proof.file).values()].find(({ kind }) => kind === 'blackHole');
      if (hole === undefined) throw new Error('every level has a black hole');
      expect(runFactsOf(proof, hole, radiusOf(hole))).toEqual([expect.objectContaining({ tone: 'good', tick: proof.run.tick })]);
    }
  });

  it('is given for an alien that overlaps her by less than rounding', () => {
    const file = withIds({
      version: 1,
      name: 'Level',
      astronaut: { x: 0, y: 0 },
      blackHole: { x: 500, y: 0 },
      aliens: [{ x: 1e-162, y: 0 }],
    });
    const proof = provenFile(file);
    const facts = [...objectsOf(proof.file).values()].flatMap((found) => runFactsOf(proof, found, radiusOf(found)));
    expect(facts.map(({ value }) => value)).toContain('ends here at 0.00 s');
    for (const { value } of facts) expect(value).not.toMatch(/NaN/);
  });

  it('does not call a wind touched that never acts, since only her centre counts', () => {
    const proof = provenFile(
      withIds({
        version: 1,
        name: 'Windy pass',
        astronaut: { x: 320, y: 360 },
        blackHole: { x: 640, y: 360 },
        asteroids: [{ x: 480, y: 360, radius: 16 }],
        winds: [{ x: 568, y: 296, radius: 51 }],
        runs: [{ name: 'solution', holds: [[56, 402]] }],
      }),
    );
    const wind = [...objectsOf(proof.file).values()].find(({ kind }) => kind === 'wind');
    if (wind === undefined) throw new Error('there is a wind');
    expect(proof.full?.events.filter(({ type }) => type === 'effect')).toEqual([]);
    expect(nearestPass(proof, wind, 51, 'box')?.gap).toBeLessThan(0);
    expect(runFactsOf(proof, wind, 51).map(({ label, value }) => `${label}: ${value}`)).toEqual([
      'her centre is inside: never: she stays outside',
      expect.stringMatching(/^closest distance: \d+(\.\d+)? px from her centre at \d\.\d\d s$/),
    ]);
  });

  /** Small scenes, whose discs she often begins in, overlap, or passes by. */
  const place = { x: fc.integer({ min: -150, max: 150 }), y: fc.integer({ min: -150, max: 150 }) };
  const disc = fc.record({ ...place, radius: fc.integer({ min: 10, max: 120 }) });
  const crowded = fc
    .record({
      astronaut: fc.record({ x: fc.constant(0), y: fc.constant(0), vx: fc.integer({ min: -60, max: 60 }) }),
      asteroids: fc.array(fc.record({ ...place, radius: fc.constant(16) }), { minLength: 1, maxLength: 2 }),
      repulsors: fc.array(disc, { maxLength: 3 }),
      winds: fc.array(disc, { maxLength: 2 }),
      aliens: fc.array(fc.record({ x: fc.integer({ min: 100, max: 300 }), y: place.y }), { maxLength: 1 }),
      wormholes: fc.array(fc.record({ ...place, toX: fc.constant(400), toY: place.y, radius: fc.constant(24) }), {
        maxLength: 1,
      }),
      runs: fc.constantFrom<[number, number][]>([], [[0, 90]], [[30, 200]]).map((holds) => [{ name: 'r', holds }]),
    })
    .map((parts): LevelFile => withIds({ version: 1, name: 'Level', blackHole: { x: 600, y: 0 }, ...parts }));

  it.each(['precise', 'arcade'] as const)('says of each disc and alien what the way of the run shows, as %s', (accuracy) => {
    fc.assert(
      fc.property(crowded, (file) => {
        const proof = createProver(() => 0).prove({
          file: createEditedLevel(file).file(),
          run: null,
          terms: { ...DEFAULT_TERMS, accuracy: ACCURACIES[accuracy] },
        });
        const { way } = proof.run;
        const { level } = proof;
        /** Ticks at which a statement about her place holds. */
        const ticksOf = (holds: (x: number, y: number, tick: number) => boolean) =>
          Array.from({ length: way.count }, (_, tick) => tick).filter((tick) =>
            holds(way.states[STATE_SIZE * tick], way.states[STATE_SIZE * tick + 1], tick),
          );
        const depth = (d: { x: number; y: number; radius: number }, x: number, y: number) =>
          d.radius - Math.hypot(x - d.x, y - d.y);
        for (const found of objectsOf(proof.file).values()) {
          const { kind, index } = found;
          const facts = runFactsOf(proof, found, radiusOf(found));
          for (const { value } of facts) expect(value).not.toMatch(/touch/);
          const [fact] = facts;
          const said = /(\d+\.\d+) s from/.exec(fact.value);
          // events are located to a tick, and between two samples she may be in and out again
          const agrees = (sure: readonly number[], possible: readonly number[]) => {
            if (sure.length > 1) expect([kind, fact.value]).not.toEqual([kind, expect.stringMatching(/^never/)]);
            if (said === null) return;
            const seconds = Number(said[1]);
            const parts = Number(/^(\d+) times/.exec(fact.value)?.[1] ?? 1);
            const slack = (2 * parts + 1) * TICK + 0.01;
            expect(seconds).toBeGreaterThanOrEqual(sure.length * TICK - slack);
            expect(seconds).toBeLessThanOrEqual(possible.length * TICK + slack);
          };
          if (kind === 'wind')
            agrees(
              ticksOf((x, y) => depth(level.winds[index], x, y) > 0.01),
              ticksOf((x, y) => depth(level.winds[index], x, y) > -0.01),
            );
          if (kind === 'repulsor') {
            const before = level.repulsors.slice(0, index);
            agrees(
              ticksOf((x, y) => depth(level.repulsors[index], x, y) > 0.01 && before.every((one) => depth(one, x, y) < -0.01)),
              ticksOf((x, y) => depth(level.repulsors[index], x, y) > -0.01 && before.every((one) => depth(one, x, y) < 0.01)),
            );
          }
          if (kind === 'asteroid' && proof.run.with?.kind !== 'asteroid') {
            const inField = (x: number, y: number, margin: number) => level.repulsors.some((one) => depth(one, x, y) > margin);
            const held = (tick: number) => proof.run.holds.some(([press, release]) => press <= tick && tick < release);
            const nearest = (x: number, y: number) =>
              level.asteroids.every(
                (one) =>
                  Math.hypot(x - one.x, y - one.y) >= Math.hypot(x - level.asteroids[index].x, y - level.asteroids[index].y),
              );
            if (level.asteroids.length === 1)
              agrees(
                ticksOf((x, y, tick) => held(tick) && nearest(x, y) && !inField(x, y, -0.01)),
                ticksOf((x, y, tick) => held(tick) && nearest(x, y) && !inField(x, y, 0.01)),
              );
          }
        }
      }),
    );
  });

  it('knows that an alien sees her from the start', () => {
    const proof = provenFile(
      withIds({
        version: 1,
        name: 'Level',
        astronaut: { x: 0, y: 0 },
        blackHole: { x: 600, y: 0 },
        asteroids: [{ x: 0, y: -200, radius: 16 }],
        aliens: [{ x: 120, y: 0 }],
        runs: [{ name: 'r', holds: [] }],
      }),
    );
    const alien = [...objectsOf(proof.file).values()].find(({ kind }) => kind === 'alien');
    if (alien === undefined) throw new Error('there is an alien');
    const facts = runFactsOf(proof, alien, 25).map(({ label, value }) => `${label}: ${value}`);
    expect(facts).toContainEqual(expect.stringMatching(/^awake: \d+\.\d+ s from 0\.00 s$/));
  });

  it('is given for every object of any level', () => {
    fc.assert(
      fc.property(arbitraryFile, (file) => {
        const proof = provenFile(file);
        for (const found of objectsOf(proof.file).values()) {
          for (const { value, tick } of runFactsOf(proof, found, radiusOf(found))) {
            expect(value).not.toMatch(/NaN|undefined|Infinity/);
            if (tick !== undefined) expect(tick).toBeLessThanOrEqual(LIMITS.tick);
          }
        }
      }),
      { numRuns: 30 },
    );
  });
});
