import { useMemo, useRef } from 'react';
import { useStore } from 'zustand';
import { type ComparableRun, compareRuns, type RunsDifference, type WaysApart, waysApart } from '../../../check/runs/index.ts';
import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import type { EdgeSlack } from '../../../solver/index.ts';
import { useInPace, useQuestion } from '../../core/ask/index.ts';
import {
  type Editor,
  type OpenLevel,
  useDocument,
  useEditor,
  useLevel,
  usePageTheme,
  useProof,
} from '../../core/context/index.ts';
import { keepAsRun } from '../../core/levels/index.ts';
import { isWhole, type LiveProof, pathOf, type SlackOf, slackQuestion } from '../../core/proof/index.ts';
import type { Results } from '../../workers/index.ts';
import {
  type ComparedRun,
  chosenOf,
  comparedOf,
  isFresh,
  MOST_COMPARED,
  type Source,
  sourceHolds,
  sourceKey,
  sourceName,
  toggleCompared,
} from './compared.ts';
import { LOOKS } from './racers.ts';

/** A compared run with what is known of it. */
export interface ComparedRow extends ComparedRun {
  readonly key: string;
  readonly name: string;
  /** Its number among the compared runs, from 1. */
  readonly number: number;
  readonly colour: string;
  readonly dashes: readonly number[];
  readonly holds: readonly Hold[];
  /** null: not simulated yet, or given up */
  readonly found: Results['trajectory'] | null;
  /** What it was simulated in; null: not yet. */
  readonly scene: Scene | null;
  /** Whether it was given up, or the level is not simulated at all. */
  readonly isGivenUp: boolean;
  /** Whether the level has changed since it was simulated. */
  readonly isStale: boolean;
  /** Whether its difference to the shown run is shown. */
  readonly isChosen: boolean;
}

/** The compared runs; re-renders when one of them is simulated, or becomes stale. */
export function useComparedRows(): readonly ComparedRow[] {
  const level = useLevel();
  const comparing = useStore(comparedOf(level));
  const theme = usePageTheme();
  // both are read through the level below
  useDocument(({ file }) => file.runs);
  useStore(level.attempts.store);
  // the holds of the shown run are those of every accuracy
  useProof(({ run }) => run.holds.join());
  const freshOf = (now: LiveProof): string =>
    comparing.runs
      .filter(({ source }) => isFresh(comparing.trajectories.get(sourceKey(source)), now, sourceHolds(level, source) ?? []))
      .map(({ slot }) => slot)
      .join();
  const fresh = useProof(freshOf).split(',');
  const isTooMuch = useProof(({ limit }) => limit === 'unchecked' || limit === 'everything');
  const chosen = chosenOf(comparing);
  return comparing.runs.flatMap((one): ComparedRow[] => {
    const { source, slot } = one;
    const holds = sourceHolds(level, source);
    if (holds === null) return [];
    const key = sourceKey(source);
    const trajectory = comparing.trajectories.get(key);
    const { dashes, [theme]: colour } = LOOKS[slot];
    return [
      {
        ...one,
        ...{ key, name: sourceName(source), number: slot + 1, colour, dashes, holds },
        found: trajectory?.found ?? null,
        scene: trajectory?.scene ?? null,
        isGivenUp: trajectory?.found === null || (trajectory === undefined && isTooMuch),
        isStale: !fresh.includes(String(slot)),
        isChosen: one === chosen,
      },
    ];
  });
}

/** Puts a run beside the shown one or takes it away; says why if there is no room. */
export function compareOrTell({ notices }: Pick<Editor, 'notices'>, level: OpenLevel, source: Source): void {
  if (source.kind === 'run' && source.name === level.proof.proof().run.name) {
    notices.show('info', `${source.name} is the shown run: compare it with another one.`, { topic: 'compare' });
    return;
  }
  if (source.kind === 'accuracy' && source.name === level.proof.proof().terms.accuracy.name) return;
  if (toggleCompared(comparedOf(level), source)) {
    notices.clear('compare');
    return;
  }
  const text = `${MOST_COMPARED} runs are compared already. Stop comparing one of them, then add ${sourceName(source)}.`;
  notices.show('warning', text, { topic: 'compare' });
}

/** Makes a compared run the shown one; they change places. An attempt has to become a run first. */
export function showCompared(editor: Editor, level: OpenLevel, source: Source): void {
  if (source.kind === 'run') {
    editor.session.setState({ run: source.name });
    return;
  }
  if (source.kind === 'accuracy') {
    const { folder } = editor.terms.getState();
    editor.settings.setState({ otherAccuracy: source.name === folder.accuracy.name ? null : source.name });
    return;
  }
  const attempt = level.attempts.store.getState().find(({ number }) => number === source.number);
  if (attempt === undefined) return;
  const text = `${sourceName(source)} is not a run of the level. Keep it as one to show and edit it.`;
  const keep = () => keepAsRun({ editor, level }, attempt);
  editor.notices.show('info', text, { topic: 'compare', actions: [{ title: 'Keep as a run', run: keep }] });
}

// how the shown run and a compared one differ

/** How the shown run and a compared one differ. */
interface ShownDifference extends WaysApart {
  readonly shown: string;
  readonly row: ComparedRow;
  readonly difference: RunsDifference;
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
  const { events } = full;
  return { scene, name, holds, outcome, time, minerals: minerals.length, clearance, events, points: pathOf(run.way) };
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
    const { end, minerals, clearance } = found;
    const other: ComparableRun = {
      holds: row.holds,
      outcome: end.outcome,
      time: end.time,
      minerals,
      clearance,
      slack: theirSlack,
    };
    const difference = compareRuns({ ...shown, slack: ownSlack }, other);
    return { key, shown: shown.name, difference, ...waysApart(shown, found) };
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
