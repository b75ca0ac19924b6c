import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import {
  type ComparableRun,
  compareRuns,
  distancesOf,
  type Partings,
  partingsOf,
  type RunsDifference,
} from '../../../check/runs/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { EdgeSlack } from '../../../solver/index.ts';
import { useInPace, useQuestion } from '../../core/ask/index.ts';
import { useEditor, useLevel, useProof } from '../../core/context/index.ts';
import { isWhole, type LiveProof, pathOf, type SlackOf, slackQuestion } from '../../core/proof/index.ts';
import { type ComparedRow, useComparedRows } from './compared-rows.ts';

/** How the shown run and a compared one differ. */
interface ShownDifference {
  readonly shown: string;
  readonly row: ComparedRow;
  readonly difference: RunsDifference;
  /** px at every tick, as long as both last */
  readonly distances: Float64Array;
  readonly partings: Partings;
  /** Whether it is that of an earlier state of the level. */
  readonly isStale: boolean;
}

/** The smallest room of a press or release, both directions together, ticks. */
const smallest = (slack: readonly { readonly earlier: number; readonly later: number }[] | null): number | null =>
  slack === null || slack.length === 0 ? null : Math.min(...slack.map(({ earlier, later }) => earlier + later));

/** The shown run as it was when the page was last idle: its arrays are overwritten by the next answer. */
const shownOf = (proof: LiveProof) => {
  const { run, full, scene } = proof;
  if (run.name === null || full === null || !isWhole(proof)) return null;
  const { name, holds, outcome, time, minerals } = run;
  const clearance = full.clearance?.distance ?? null;
  return { scene, name, holds, outcome, time, minerals: minerals.length, clearance, points: pathOf(run.way) };
};

const NOTHING = () => null;

/** The difference of the shown run and the chosen one; null while one of them is not known. @param measures whether slack is measured */
export function useDifference(measures = false): ShownDifference | null {
  const level = useLevel();
  const row = useComparedRows().find(({ isChosen }) => isChosen) ?? null;
  const isAsked = row !== null;
  const shown = useInPace(level.proof.store, isAsked ? shownOf : NOTHING, 'idle');
  const analysis = useStore(level.analysis);
  const otherSlack = useSlack(measures && row?.found?.end.outcome === 'completed' && !row.isStale ? row.holds : null);
  const own = shown !== null && shown.outcome === 'completed' && analysis?.holds === shown.holds.join() ? analysis.slack : null;
  const [ownSlack, theirSlack] = [smallest(own), smallest(otherSlack)];
  const found = row?.found ?? null;
  const key = row === null ? '' : `${row.key} ${row.holds.join()}`;
  // both must be of the same state of the level
  const areOfOne = shown !== null && found !== null && row?.scene === shown.scene;
  // biome-ignore lint/correctness/useExhaustiveDependencies: of the row, only these matter
  const made = useMemo(() => {
    if (shown === null || row === null || found === null || !areOfOne) return null;
    const { end, minerals, clearance, points } = found;
    const other: ComparableRun = {
      holds: row.holds,
      outcome: end.outcome,
      time: end.time,
      minerals,
      clearance,
      slack: theirSlack,
    };
    // the last entry of each is at its end, which is no tick
    const distances = distancesOf(shown.points.subarray(0, -2), points.subarray(0, -2));
    const difference = compareRuns({ ...shown, slack: ownSlack }, other);
    return { key, shown: shown.name, difference, distances, partings: partingsOf(distances) };
  }, [shown, found, key, areOfOne, ownSlack, theirSlack]);
  const last = useRef(made);
  if (made !== null) last.current = made;
  // until the next one is known, the last difference of these runs stays, and says that it is old
  const kept = made ?? (last.current?.key === key ? last.current : null);
  return kept === null || row === null ? null : { ...kept, row, isStale: made === null };
}

/** How far each press and release of a run of this level may move alone, measured by a worker; null until it is known. */
function useSlack(holds: readonly Hold[] | null): readonly EdgeSlack[] | null {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const scene = useProof((now) => now.scene);
  const key = holds?.join() ?? null;
  // biome-ignore lint/correctness/useExhaustiveDependencies: holds are known by their key
  const of = useMemo((): SlackOf | null => {
    const { level, terms } = proof.proof();
    return holds === null ? null : { of: scene, level, terms, holds, goal: { minerals: 'any' } };
  }, [proof, scene, key]);
  const asked = useQuestion(slackQuestion, desk, of);
  return asked !== null && asked.of === of ? asked.answer : null;
}
