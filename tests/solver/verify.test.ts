import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile } from '../../engine/index.ts';
import type { Level } from '../../schema/index.ts';
import { createSearch, type Proof, proveImpossible, proveMineralsUnreachable, verifyProof } from '../../solver/index.ts';
import { isDeep, itDeep, itQuick } from '../depth.ts';
import { ALSO, at, LEVELS, level } from './impossible-levels.ts';

const proofOf = (name: string): Proof => {
  const code = ALSO[name]?.[0] ?? name;
  const proof = proveImpossible(LEVELS[name]);
  if (proof?.code !== code) throw new Error(`expected a proof of the kind ${code}, found ${proof?.code}`);
  return proof;
};

type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** Every value in a JSON document, by its path. */
function ways(json: Json, way: (string | number)[] = []): (string | number)[][] {
  if (json === null || typeof json !== 'object') return [way];
  const inner = Array.isArray(json) ? [...json.entries()] : Object.entries(json);
  return [way, ...inner.flatMap(([key, value]) => ways(value, [...way, key]))];
}

/** The JSON document with one value changed by `change`; undefined removes it. */
function changed(json: Json, way: readonly (string | number)[], change: (old: Json) => Json | undefined): Json | undefined {
  if (way.length === 0) return change(json);
  const [key, ...rest] = way;
  if (Array.isArray(json)) {
    return json.flatMap((value, i) => (i === key ? (changed(value, rest, change) ?? []) : [value])) as Json[];
  }
  const copy = { ...(json as { [key: string]: Json }) };
  const value = changed(copy[key], rest, change);
  if (value === undefined) delete copy[key];
  else copy[key] = value;
  return copy;
}

const CHANGES: ((old: Json) => Json | undefined)[] = [
  () => undefined,
  () => null,
  () => 'range',
  () => [],
  () => ({}),
  (old) => (typeof old === 'number' ? old + 1 : 0),
  (old) => (typeof old === 'number' ? old - 40 : -1),
  (old) => (typeof old === 'number' ? -old : { kind: 'nova', index: 0 }),
  (old) => (typeof old === 'number' ? old / 3 : { kind: 'range' }),
  (old) => (typeof old === 'number' ? 1e300 : { kind: 'start' }),
  (old) => (Array.isArray(old) ? [...old].reverse() : old),
  (old) => (Array.isArray(old) ? old.slice(0, Math.ceil(old.length / 2)) : old),
  (old) => (Array.isArray(old) ? [...old, 'arcade', 0] : 'arcade'),
];

/** Of larger certificates, so many changes are tried. */
const MOST_CHANGES = 200;

const known = new Map<string, Proof | null>();

/** Whether the prover confirms a claim: about the object, at each accuracy that the proof claims to cover. */
function isTrue(of: Level, { about, covers, maxTime }: Proof): boolean {
  const confirmed = new Set<string>();
  // The proof for the last accuracy mostly covers the others.
  return covers.toReversed().every((accuracy) => {
    if (confirmed.has(accuracy)) return true;
    const key = JSON.stringify([of, about, accuracy, maxTime]);
    const options = { accuracy, maxTime: maxTime ?? 60 };
    const prove = () =>
      about.kind === 'blackHole'
        ? proveImpossible(of, options)
        : (proveMineralsUnreachable({ ...of, minerals: of.minerals.slice(0, about.index + 1) }, options).find(
            (proof) => proof.about.kind === 'mineral' && proof.about.index === about.index,
          ) ?? null);
    if (!known.has(key)) known.set(key, prove());
    const proof = known.get(key) ?? null;
    for (const name of proof?.covers ?? []) confirmed.add(name);
    return proof !== null;
  });
}

function findsNothing(of: Level): boolean {
  const search = createSearch(compile(of), { seed: 1 });
  search.advance(30_000);
  return search.solutions.length === 0;
}

describe.each(Object.keys(LEVELS))('a certificate of the kind %s', (code) => {
  const proof = proofOf(code);
  // The prover tries few axes and grids, and leaves more room than the checker requires: where it finds no proof, a search must
  // find no run.
  const isTight = code === 'line-trap with a dead end' || code === 'flowpipe';

  it('passes as it is', () => expect(verifyProof(LEVELS[code], proof)).toEqual({ ok: true }));

  // whether a changed claim is true takes a second for orbits
  const test = code === 'orbits' ? itDeep : it;

  test('any change to the proof is rejected, or its claim is still true', () => {
    const places = ways(proof as unknown as Json).filter(([first]) => first !== 'reason');
    let rejected = 0;
    // several changes of a value may come to the same
    const seen = new Set<string>();
    const tamper = (way: (string | number)[], change: (old: Json) => Json | undefined) => {
      const tampered = (changed(proof as unknown as Json, way, change) ?? {}) as unknown as Proof;
      const text = JSON.stringify(tampered);
      if (seen.has(text)) return;
      seen.add(text);
      const verdict = verifyProof(LEVELS[code], tampered);
      if (verdict.ok) expect(`${way.join('.')}: ${isTrue(LEVELS[code], tampered)}`).toBe(`${way.join('.')}: true`);
      else rejected++;
    };
    if (places.length * CHANGES.length <= MOST_CHANGES) {
      for (const way of places) for (const change of CHANGES) tamper(way, change);
    } else {
      fc.assert(fc.property(fc.constantFrom(...places), fc.constantFrom(...CHANGES), tamper), { numRuns: MOST_CHANGES });
    }
    expect(rejected).toBeGreaterThan(isDeep ? 15 : 5);
  });

  test('any change to the level is rejected, or the proof still holds', () => {
    const numbers = ways(LEVELS[code] as unknown as Json).filter((way) => /^(x|y|vx|vy|radius|range)$/.test(String(way.at(-1))));
    fc.assert(
      fc.property(fc.nat(numbers.length - 1), fc.integer({ min: -300, max: 300 }), (which, by) => {
        const moved = (old: Json) => Math.max(numbers[which].at(-1) === 'radius' ? 1 : -1e6, (old as number) + by);
        const edited = changed(LEVELS[code] as unknown as Json, numbers[which], moved) as unknown as Level;
        if (verifyProof(edited, proof).ok) expect(isTrue(edited, proof) || (isTight && findsNothing(edited))).toBe(true);
      }),
      { numRuns: code === 'flowpipe' ? 6 : 15 },
    );
  });

  itQuick('is about nothing else', () => {
    const other = { ...proof, about: { kind: 'mineral', index: 0 } as const };
    expect(verifyProof(LEVELS[code], other).ok).toBe(isTrue(LEVELS[code], other));
    expect(verifyProof(LEVELS[code], { ...proof, about: { kind: 'mineral', index: 2 } }).ok).toBe(false);
  });
});

describe('what the checker says', () => {
  const why = (of: Level, proof: Proof) => {
    const verdict = verifyProof(of, proof);
    return verdict.ok ? 'ok' : verdict.why;
  };

  it.each([
    ['enclosed', { novae: [] }, 'it names something other than a hazard that stands still'],
    ['line-trap', { novae: [at(220, 60)] }, 'the hazard at an end of the stretch may not stop her'],
    ['line-trap', { novae: [at(220, 0)], astronaut: { x: 0, y: 0, vx: 1 } }, 'she is not at rest at the start'],
    ['starts-in-hazard', { novae: [] }, 'it names a hazard that the level does not have'],
    ['flowpipe', { astronaut: { x: 0, y: 0, vx: 60 }, blackHole: { x: 60, y: 0 } }, 'she may touch it in step'],
    ['flowpipe', { aliens: [], blackHole: { x: 300, y: 300 } }, 'it names a hazard that the level does not have'],
    ['nothing-in-range', { astronaut: { x: -50, y: 0 } }, 'asteroid 1 is not farther from the start than the range'],
  ])('%s: %j', (code, more, words) => {
    expect(why(level(more), proofOf(code))).toContain(words);
  });

  it('a proof for continuous time is refused for arcade', () => {
    const proof = proofOf('line-trap');
    expect(proof.covers).not.toContain('arcade');
    expect(why(LEVELS['line-trap'], { ...proof, covers: ['arcade'] })).toContain('with frames she may leave the line');
  });
});
