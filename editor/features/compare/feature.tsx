import { useMemo } from 'react';
import { waysApart } from '../../../check/runs/index.ts';
import type { DrawnPart } from '../../canvas/index.ts';
import type { Command, Destination } from '../../core/commands/index.ts';
import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { laterPart } from '../../core/panel/index.ts';
import { pathOf } from '../../core/proof/index.ts';
import { type Beside, looksLike } from '../../timeline/index.ts';
import { accuracyNameOf } from '../../workers/index.ts';
import type { Feature } from '../feature.ts';
import { chosenOf, comparedOf, isCompared, type Source, sourceKey, toggleAccuracies, watchCompared } from './compared.ts';
import { compareOrTell, showCompared, useComparedRows, useDifference } from './compared-rows.ts';
import { RaceLayer } from './race-layer.ts';
import { type Race, raceOf } from './racers.ts';

const AccuracyLens = laterPart(() => import('./AccuracyLens.tsx').then((there) => there.AccuracyLens));
const ComparedLanes = laterPart(() => import('./ComparedLanes.tsx').then((there) => there.ComparedLanes));

const drawn: DrawnPart<Race> = {
  pictureOf: raceOf,
  draw: (scene, theme) => new RaceLayer(scene, theme),
};

/** What the timeline shows of compared runs beside the shown one. */
function useBeside(): Beside {
  const ticks = useComparedRows().reduce(
    (most, { found }) => Math.max(most, found === null ? 0 : Math.ceil(60 * found.end.time)),
    0,
  );
  const difference = useDifference();
  const [against, distances, partings] = [difference?.row.name, difference?.distances, difference?.partings];
  const apart = useMemo(
    () => (against && distances && partings ? { name: against, distances, partings } : null),
    [against, distances, partings],
  );
  return { ticks, apart };
}

/** Runs beside the shown one: their ways and lanes, and how they differ. */
export const compare: Feature = {
  name: 'compare',
  canvas: { drawn },
  timeline: {
    lanes: (given) => (useComparedRows().length > 0 ? <ComparedLanes {...given} /> : null),
    useBeside,
    legend: {
      graphs: [[looksLike('apart'), 'The distance to the compared run; bars where they part and come near each other again.']],
    },
  },
  section: { panel: 'accuracy', content: AccuracyLens },
  levelCommands: compareCommands,
  destinations: compareDestinations,
  open: ({ desk }, level) => watchCompared(level, desk),
};

/** Commands of compared runs. */
function compareCommands(editor: Editor, level: OpenLevel): readonly Command[] {
  const { session } = editor;
  const store = comparedOf(level);
  /** The next run of the list that is neither shown nor compared, after the shown one and around; null: there is none. */
  const nextRun = (): Source | null => {
    const runs = level.document.file().runs ?? [];
    const from = runs.findIndex(({ name }) => name === level.proof.proof().run.name);
    for (let i = 1; i < runs.length; i++) {
      const source: Source = { kind: 'run', name: runs[(from + i) % runs.length].name };
      if (!isCompared(store.getState(), source)) return source;
    }
    return null;
  };
  const needsOne = () => (store.getState().runs.length === 0 ? 'compare a run first' : null);
  return [
    {
      id: 'compare.next',
      title: 'Compare with the next run',
      group: 'Run',
      keys: ['c'],
      needs: () => (nextRun() === null ? 'the level has no other run to compare' : null),
      run: () => {
        const source = nextRun();
        if (source !== null) compareOrTell(editor, level, source);
      },
    },
    {
      id: 'compare.attempt',
      title: 'Compare with the last attempt',
      group: 'Run',
      needs: () => (level.attempts.store.getState().length === 0 ? 'play first: there is no attempt yet' : null),
      run: () => {
        const last = level.attempts.store.getState().at(-1);
        if (last !== undefined) compareOrTell(editor, level, { kind: 'attempt', number: last.number });
      },
    },
    {
      id: 'compare.accuracies',
      title: 'Compare all accuracies',
      group: 'Run',
      needs: () => null,
      run: () => toggleAccuracies(store, accuracyNameOf(level.proof.proof().terms)),
    },
    {
      id: 'compare.choose',
      title: 'Show the difference to the next compared run',
      group: 'Run',
      needs: needsOne,
      run: () => {
        const now = store.getState();
        const chosen = chosenOf(now);
        const at = now.runs.findIndex(({ slot }) => slot === chosen?.slot);
        const next = now.runs[(at + 1) % now.runs.length];
        store.setState({ chosen: sourceKey(next.source) });
      },
    },
    {
      id: 'compare.parting',
      title: 'Go to where the compared runs part',
      group: 'Run',
      keys: ['p'],
      needs: () => needsOne() ?? (partingTick(level) === null ? 'the runs do not part' : null),
      run: () => {
        const tick = partingTick(level);
        if (tick !== null) session.setState({ tick, hoverTick: null, isPlayingBack: false });
      },
    },
    {
      id: 'compare.show',
      title: 'Show the compared run, and compare the shown one with it',
      group: 'Run',
      keys: ['x'],
      needs: needsOne,
      run: () => {
        const one = chosenOf(store.getState());
        if (one !== null) showCompared(editor, level, one.source);
      },
    },
    {
      id: 'compare.clear',
      title: 'Stop comparing runs',
      group: 'Run',
      keys: ['Shift+c'],
      needs: needsOne,
      run: () => store.setState({ runs: [] }),
    },
  ];
}

/** The first tick at which the shown run and the chosen one are apart; null: they are not, or it is not known. */
function partingTick(level: OpenLevel): number | null {
  const now = comparedOf(level).getState();
  const one = chosenOf(now);
  const found = one === null ? null : (now.trajectories.get(sourceKey(one.source))?.found ?? null);
  const points = pathOf(level.proof.proof().run.way);
  return found === null ? null : waysApart({ points, events: [] }, found).partings.parts;
}

/** Runs to compare with, and those that are compared. */
function compareDestinations(editor: Editor): readonly Destination[] {
  const level = editor.open.getState();
  if (level === null) return [];
  const shown = level.proof.proof().run.name;
  return (level.document.file().runs ?? [])
    .filter(({ name }) => name !== shown)
    .map(({ name }) => {
      const source = { kind: 'run', name } as const;
      const isIn = isCompared(comparedOf(level).getState(), source);
      return {
        key: `compare ${name}`,
        group: 'Run',
        title: `${isIn ? 'Stop comparing' : 'Compare with'} ${name}`,
        detail: '',
        go: () => compareOrTell(editor, level, source),
      };
    });
}
