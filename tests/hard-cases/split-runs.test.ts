import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { compile, createSimulation, type Simulation, STATE_SIZE, simulate } from '../../engine/index.ts';
import type { Hold } from '../../schema/index.ts';
import { accuracyNames } from '../engine/accuracies.ts';
import { CASE_SECONDS, type HardCase, hardCases } from './cases.ts';

const cases = hardCases();
const arbitraryCase = fc.constantFrom(...cases);
const ticksOf = (c: HardCase) => 60 * (c.maxTime ?? CASE_SECONDS);
const isHeld = (c: HardCase, tick: number) => c.holds.some(([press, release]) => press <= tick && tick < release);

/** Everything about a simulation: its state, and everything that a later run could depend on. */
function standing(simulation: Simulation): unknown {
  const state = new Float64Array(STATE_SIZE);
  simulation.readState(state);
  // at the end, only the requested ticks may differ: an end at a tick belongs to the call before and to the one after
  const all = simulation.ending === null ? [...simulation.snapshot()] : null;
  return { state: [...state], ending: simulation.ending, all };
}

/** Simulates a case up to a tick; at the ticks in `cuts` advances by 0 and continues from a snapshot in another simulation. */
function playCut(c: HardCase, accuracy: (typeof accuracyNames)[number], cuts: ReadonlySet<number>): unknown {
  const scene = compile(c.level, accuracy);
  let simulation = createSimulation(scene);
  const end = ticksOf(c);
  const stops = [...new Set([...cuts, ...c.holds.flat(), end])].filter((tick) => tick <= end).sort((a, b) => a - b);
  for (const stop of stops) {
    const held = isHeld(c, simulation.tick);
    if (simulation.ending === null && stop > simulation.tick) simulation.advance(stop - simulation.tick, held);
    if (!cuts.has(stop) || simulation.ending !== null) continue;
    simulation.advance(0, held);
    const next = createSimulation(scene);
    next.restore(simulation.snapshot());
    simulation = next;
  }
  return standing(simulation);
}

describe.each(accuracyNames)('hard cases in parts: %s', (accuracy) => {
  it('give the same bits if they are split anywhere, with steps of length 0 and snapshots', () => {
    fc.assert(
      fc.property(arbitraryCase, fc.array(fc.double({ min: 0, max: 1, noNaN: true }), { maxLength: 12 }), (c, parts) => {
        const cuts = new Set(parts.map((part) => Math.floor(part * ticksOf(c))));
        expect(playCut(c, accuracy, cuts)).toEqual(playCut(c, accuracy, new Set()));
      }),
      { numRuns: 25 },
    );
  });

  it('do not change if a hold is split into single ticks or into two adjacent holds', () => {
    fc.assert(
      fc.property(arbitraryCase, fc.nat(200), fc.integer({ min: 1, max: 80 }), (c, press, length) => {
        const scene = compile(c.level, accuracy);
        const maxTime = Math.min(6, c.maxTime ?? CASE_SECONDS);
        const hash = (holds: readonly Hold[]) => simulate(scene, holds, { maxTime }).hash;
        const release = press + length;
        const middle = press + Math.floor(length / 2);
        const joined = hash([[press, release]]);
        const ticks = Array.from({ length }, (_, i): Hold => [press + i, press + i + 1]);
        expect(hash(ticks)).toBe(joined);
        expect(
          hash([
            [press, middle],
            [middle, release],
            [release, release],
          ]),
        ).toBe(joined);
      }),
      { numRuns: 10 },
    );
  });
});
