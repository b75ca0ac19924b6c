import { useCallback, useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { outcomeAsPredicate } from '../../../check/words/index.ts';
import { ACCURACIES, type AccuracyName } from '../../../engine/index.ts';
import { METHODS } from '../../../engine/work-precision/index.ts';
import { levelDiagram } from '../../../picture/accuracy/index.ts';
import type { Hold } from '../../../schema/index.ts';
import { onDemand, question } from '../../core/ask/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { isWhole, type LiveProof, type PlayedFile, type ProofStore, withoutRuns } from '../../core/proof/index.ts';
import { type AnswerOf, jobs, type Setting, type SettingError } from '../../workers/index.ts';

/** The measured cost of all settings for the runs of a level. */
export interface MeasuredSettings {
  readonly runs: readonly ({ readonly name: string | null } & AnswerOf<typeof jobs.accuracy>[number])[];
  readonly level: string;
  readonly range: number;
  readonly played: PlayedFile;
  /** Of all runs, measured or not. */
  readonly holds: string;
  /** Runs of the level that were not measured: there are too many. */
  readonly left: number;
}

interface Measuring {
  readonly phase: 'idle' | 'measuring' | 'failed';
  readonly message: string | null;
  readonly measured: MeasuredSettings | null;
  readonly start: () => void;
  readonly cancel: () => void;
}

/** What every setting costs for the runs of a level. */
export const accuracyQuestion = onDemand(jobs.accuracy);

/** The most runs that are measured. */
const MOST_RUNS = 8;

/** The runs of the level; the shown one, in which she drifts, where there are none. */
const runsOf = ({ level, run }: LiveProof): readonly { readonly name: string | null; readonly holds: readonly Hold[] }[] =>
  level.runs.length === 0 ? [{ name: null, holds: run.holds }] : level.runs;

/** Tells whether runs have changed. */
export const holdsOfAll = (proof: LiveProof): string =>
  runsOf(proof)
    .map(({ name, holds }) => `${name} ${holds.join()}`)
    .join(';');

/** Measures all settings in a worker on demand; the job ends when the component unmounts. */
export function useMeasured(): Measuring {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const [measured, setMeasured] = useState<MeasuredSettings | null>(null);
  const accuracy = useMemo(() => accuracyQuestion(desk), [desk]);
  useEffect(() => accuracy.close, [accuracy]);
  const { phase, message } = useStore(accuracy.store);
  const start = useCallback(() => {
    const now = proof.proof();
    const { level, terms, file } = now;
    const all = runsOf(now);
    const runs = all.slice(0, MOST_RUNS);
    const about = { level: level.name, range: level.range, played: { file, level }, holds: holdsOfAll(now) };
    accuracy.ask({ level: withoutRuns(level), terms, runs: runs.map(({ holds }) => holds), methods: 'all' }, ({ answer }) => {
      if (answer === null) return;
      const named = answer.map((one, i) => ({ name: runs[i].name, ...one }));
      setMeasured({ ...about, runs: named, left: all.length - runs.length });
    });
  }, [accuracy, proof]);
  const is = phase === 'asking' ? 'measuring' : phase === 'failed' ? 'failed' : 'idle';
  return { phase: is, message, measured, start, cancel: accuracy.forget };
}

/** The work-precision diagram of the runs of a level. @param each whether each run has a point of its own */
export function settingsDiagram({ level, range, runs }: MeasuredSettings, current: AccuracyName, each: boolean) {
  const title = `${level}: ${runs.length === 1 ? (runs[0].name ?? 'she drifts') : `${runs.length} runs`}`;
  return levelDiagram({
    title,
    subtitle: ['Error and time of every setting, measured in this browser.'],
    used: current,
    named: NAMES,
    each,
    runs: runs.map(({ name, knownTo, settings }) => ({
      name,
      knownTo,
      settings: settings.flatMap((setting) => {
        const accuracy = METHODS.find((one) => one.name === setting.name);
        return accuracy === undefined ? [] : [{ ...setting, accuracy, end: outcomeAsPredicate(setting, range) }];
      }),
    })),
  });
}

/** in display order */
export const NAMES = Object.keys(ACCURACIES) as readonly AccuracyName[];

/** ms without a change before a run is compared again */
const REST = 200;

/** How the shown run goes at every named setting, and what each costs. */
export const namedQuestion = question({
  job: jobs.accuracy,
  request(known: LiveProof) {
    const { level, terms, run } = known;
    return isWhole(known) ? { level: withoutRuns(level), terms, runs: [run.holds], methods: 'named' as const } : null;
  },
  follows: {
    wait: { rest: REST },
    of: (proof: ProofStore): LiveProof => proof.proof(),
    same: (asked, now) =>
      asked.scene === now.scene && isWhole(asked) === isWhole(now) && asked.run.holds.join() === now.run.holds.join(),
    on: (proof) => [proof.store.subscribe],
  },
});

interface NamedResults extends Omit<AnswerOf<typeof jobs.accuracy>[number], 'settings'> {
  /** Without costs until these are measured. */
  readonly settings: readonly (SettingError & Partial<Pick<Setting, 'cost'>>)[];
}

interface ShownResults extends NamedResults {
  /** Whether they belong to the present run. */
  readonly isFresh: boolean;
}

/** The named settings on the shown run; what was known before stays until something newer is. */
export function useNamedResults(): ShownResults {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const asked = useMemo(() => namedQuestion(desk, proof), [desk, proof]);
  useEffect(() => asked.close, [asked]);
  const { answer, progress, phase } = useStore(asked.store);
  const known: NamedResults | null = (answer ?? progress)?.[0] ?? null;
  const [last, setLast] = useState<NamedResults>({ settings: [], knownTo: null, doubt: null, unmeasured: [] });
  useEffect(() => {
    if (known !== null) setLast(known);
  }, [known]);
  return { ...(known ?? last), isFresh: known !== null || phase === 'nothing' || phase === 'failed' };
}
