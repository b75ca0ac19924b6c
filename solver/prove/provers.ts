import { proveNothingInRange, proveOutOfRange, proveStartsInHazard } from './by-distance.ts';
import { proveCovered } from './covered.ts';
import { FINEST_BOXES, mayDoom, proveDoomed } from './doomed.ts';
import { proveEnclosed } from './enclosure.ts';
import { FINEST_PIPES, mayFlow, proveFlowpipe } from './flowpipe.ts';
import { proveDeadEnds, proveLineTrap } from './line.ts';
import { FINEST_ORBITS, mayOrbit, proveOrbits } from './orbits/index.ts';
import type { About, Proof, Prover } from './proof.ts';
import type { Setting, Thing } from './setting.ts';

/** A prover, and what decides when it is tried. */
export interface ProverEntry {
  /** Returns a proof, or null when it finds none. A higher fineness proves more and costs more. */
  readonly prove: (setting: Setting, about: About, goal: Thing, fineness: number) => Proof | null;
  /** At a glance, in milliseconds, or in up to seconds; `longest` has a share of its own in any limit on the work. */
  readonly takes: 'a glance' | 'milliseconds' | 'seconds' | 'longest';
  /**
   * Of which states of a run a proof can tell that they are lost, as a proof about the level that starts there: none, those in
   * which her box is upright, or all. The last hold at any angle because they take her box for a disc, of half its shorter side
   * where a hazard must overlap it and of half its diagonal where it could touch the black hole, or examine every angle.
   */
  readonly holdsFor: 'the start' | 'upright states' | 'all states';
  /** Where she is known to live on for longer than this, s, it is not worth trying. */
  readonly within: number;
  /** The greatest fineness at which it differs from a lower one; 0 if it has none. */
  readonly finest: number;
  /** Whether it may find a proof with this fineness. It is a quick look: true says nothing. */
  readonly mayApply: (setting: Setting, fineness: number) => boolean;
}

/** A prover that does not follow her. */
const unfollowed = (
  prove: ProverEntry['prove'],
  takes: ProverEntry['takes'],
  holdsFor: ProverEntry['holdsFor'],
): ProverEntry => ({ prove, takes, holdsFor, within: Number.POSITIVE_INFINITY, finest: 0, mayApply: () => true });

/** The provers by name, in the order in which they are tried: proofs that a designer understands at a glance come first. */
export const PROVERS: Readonly<Record<Prover, ProverEntry>> = {
  'nothing-in-range': unfollowed(proveNothingInRange, 'a glance', 'the start'),
  'starts-in-hazard': unfollowed(proveStartsInHazard, 'a glance', 'the start'),
  'out-of-range': unfollowed(proveOutOfRange, 'a glance', 'all states'),
  'line-trap': unfollowed(proveLineTrap, 'a glance', 'upright states'),
  covered: unfollowed(proveCovered, 'milliseconds', 'all states'),
  enclosed: unfollowed(proveEnclosed, 'milliseconds', 'all states'),
  'dead-end': unfollowed(proveDeadEnds, 'milliseconds', 'upright states'),
  doomed: {
    prove: proveDoomed,
    takes: 'seconds',
    holdsFor: 'all states',
    within: 8,
    finest: FINEST_BOXES,
    mayApply: mayDoom,
  },
  flowpipe: {
    prove: proveFlowpipe,
    takes: 'seconds',
    holdsFor: 'upright states',
    within: 8,
    finest: FINEST_PIPES,
    mayApply: mayFlow,
  },
  orbits: {
    prove: proveOrbits,
    takes: 'longest',
    holdsFor: 'all states',
    within: 20,
    finest: FINEST_ORBITS,
    mayApply: mayOrbit,
  },
};

/** The names of the provers for which this is true, in the order in which they are tried. */
export const proversThat = (is: (prover: ProverEntry) => boolean): Prover[] =>
  (Object.keys(PROVERS) as Prover[]).filter((name) => is(PROVERS[name]));
