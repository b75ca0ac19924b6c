import { describe, expect, it } from 'vitest';
import { compile, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold, Level } from '../../schema/index.ts';
import { type Proof, proveImpossible, verifyProof } from '../../solver/index.ts';
import { isHunt } from '../depth.ts';
import { LEVELS } from './impossible-levels.ts';

// Changes every number of a certificate in every way: the certificate stays refused for a level that a run completes.
// Certificates with many sets are in certificate-sets.test.ts.

type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** Certificates with one number, or two adjacent ones, changed. */
function* changedNumbers(certificate: Json): Generator<Json> {
  const copy = JSON.parse(JSON.stringify(certificate)) as Json;
  const places: [holder: { [key: string]: Json }, key: string][] = [];
  const look = (json: Json): void => {
    if (json === null || typeof json !== 'object') return;
    for (const [key, value] of Object.entries(json)) {
      if (typeof value === 'number') places.push([json as { [key: string]: Json }, key]);
      else look(value);
    }
  };
  look(copy);
  for (const [holder, key] of places) {
    const old = holder[key] as number;
    for (const by of [1e-9, 1e-4, 0.1, 10, 1000]) {
      for (const value of [old + by, old - by, old * (1 + by), old / (1 + by)]) {
        holder[key] = value;
        yield copy;
      }
    }
    for (const value of [0, -old, 1, -1, 1e9, -1e9, Number.NaN, Number.POSITIVE_INFINITY, null]) {
      holder[key] = value;
      yield copy;
    }
    holder[key] = old;
  }
}

const WAYS: readonly (readonly Hold[])[] = [[], [[0, 600]], [[6, 20]], [[0, 30]]];

/** The level with its black hole moved to where a run passes, so that her box barely touches it or overlaps it well. */
function completable(of: Level): Level[] {
  return WAYS.flatMap((holds) => {
    const { time, trajectory } = simulate(compile(of), holds);
    const state = new Float64Array(STATE_SIZE);
    return [0.3, 0.6, 0.95].flatMap((share) => {
      trajectory.at(share * time, state);
      return [0, 33].flatMap((above) => {
        const blackHole = { ...of.blackHole, x: state[0], y: state[1] + above };
        const level = { ...of, blackHole };
        return simulate(compile(level), holds).outcome === 'completed' ? [level] : [];
      });
    });
  });
}

const CARRY_SETS = ['doomed', 'flowpipe'];

describe.each(Object.keys(LEVELS).filter((name) => !CARRY_SETS.includes(name)))('%s', (name) => {
  it('no changed number shows that a level is impossible which a run completes', () => {
    const proof = proveImpossible(LEVELS[name], { accuracy: 'precise' }) as Proof;
    const levels = completable(LEVELS[name]);
    // A run that ends at once passes nothing, and neither does one that is covered or enclosed.
    if (!['nothing-in-range', 'starts-in-hazard'].includes(name)) expect(levels.length).toBeGreaterThan(0);
    // A hunt tries all of them.
    for (const level of levels.filter((_, i) => isHunt || i % 3 === 0)) {
      const accepts = (certificate: unknown) =>
        verifyProof(level, { ...proof, covers: ['precise'], certificate: certificate as Proof['certificate'] }).ok;
      expect(accepts(proof.certificate)).toBe(false);
      for (const changed of changedNumbers(proof.certificate as unknown as Json)) {
        if (accepts(changed)) expect.fail(JSON.stringify(changed));
      }
    }
  });
});
