import { useEffect, useMemo, useState } from 'react';
import { countMinerals, type RunEnd } from '../../../check/words/index.ts';
import { joinHolds, type Scene, simulate } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { inSlices } from '../../core/ask/index.ts';
import { useLevel, useProof } from '../../core/context/index.ts';
import { isWhole, type LiveProof } from '../../core/proof/index.ts';

/** The id of the field with the shown run as text, for the command that goes to it. */
export const SCRIPT_FIELD = 'run-as-text';

/** How a run of the level ends. */
export interface RunSummary extends RunEnd {
  /** number of different minerals collected */
  readonly minerals: number;
}

/** ms without a change before the runs that are not shown are simulated */
const PAUSE = 150;
/** ms of simulating before the page gets its turn */
const SLICE = 8;

const keyOf = (holds: readonly Hold[]): string => joinHolds(holds).join();

/** Simulates the runs that are not known yet. */
function* playAll(scene: Scene, runs: readonly (readonly Hold[])[], known: Map<string, RunSummary>): Generator<null, void, void> {
  for (const joined of runs.map(joinHolds)) {
    if (known.has(joined.join())) continue;
    const run = simulate(scene, joined);
    const { outcome, with: touched, time, tick } = run;
    known.set(joined.join(), { outcome, with: touched, time, tick, minerals: countMinerals(run) });
    yield null;
  }
}

const shownOf = (proof: LiveProof): RunSummary | null =>
  isWhole(proof) ? { ...proof.run, minerals: proof.run.minerals.length } : null;

const NONE: readonly never[] = [];

/** How every run of the open level ends: the shown one at once, the others a moment later; null if not known yet. */
export function useRunEnds(
  runs: readonly { readonly name: string; readonly holds: readonly Hold[] }[],
): (name: string) => RunSummary | null {
  const { proof } = useLevel();
  const scene = useProof((state) => state.scene);
  const shown = useProof((state) => state.run);
  const isPlayed = useProof(isWhole);
  const [known, setKnown] = useState<{ readonly scene: Scene; readonly ends: ReadonlyMap<string, RunSummary> } | null>(null);
  const ends = useMemo(() => ({ scene, map: new Map<string, RunSummary>() }), [scene]);
  useEffect(() => {
    // a simulation that the page has given up would block it here as well
    const steps = playAll(ends.scene, isPlayed ? runs.map(({ holds }) => holds) : NONE, ends.map);
    const onSlice = () => setKnown({ scene: ends.scene, ends: new Map(ends.map) });
    return inSlices(steps, { wait: PAUSE, slice: SLICE, onSlice });
  }, [ends, runs, isPlayed]);
  return (name) => {
    if (name === shown.name) return shownOf(proof.proof());
    const run = runs.find((other) => other.name === name);
    return run === undefined || known?.scene !== scene ? null : (known.ends.get(keyOf(run.holds)) ?? null);
  };
}
