import { useStore } from 'zustand';
import type { Scene } from '../../../engine/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { type Editor, type OpenLevel, useDocument, useLevel, usePageTheme, useProof } from '../../core/context/index.ts';
import { keepAsRun } from '../../core/levels/index.ts';
import type { LiveProof } from '../../core/proof/index.ts';
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
  const attempt = level.attempts.store.getState().find(({ number }) => number === source.number);
  if (attempt === undefined) return;
  const text = `${sourceName(source)} is not a run of the level. Keep it as one to show and edit it.`;
  const keep = () => keepAsRun({ editor, level }, attempt);
  editor.notices.show('info', text, { topic: 'compare', actions: [{ title: 'Keep as a run', run: keep }] });
}
