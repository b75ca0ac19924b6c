import { useCallback, useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { type AccuracyName, isAccuracyName } from '../../../engine/index.ts';
import { METHODS } from '../../../engine/work-precision/index.ts';
import { drawDiagram, type Ground, linesOf, noteOf } from '../../../picture/accuracy/index.ts';
import { onDemand } from '../../core/ask/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { type PlayedFile, withoutRuns } from '../../core/proof/index.ts';
import { jobs, type Setting } from '../../workers/index.ts';

/** The measured cost of all settings for one level and run. */
export interface MeasuredSettings {
  readonly settings: readonly Setting[];
  /** How exactly the reference is known, px; null: no second one confirms it. */
  readonly knownTo: number | null;
  readonly level: string;
  readonly run: string | null;
  readonly played: PlayedFile;
  readonly holds: string;
}

interface Measuring {
  readonly phase: 'idle' | 'measuring' | 'failed';
  readonly message: string | null;
  readonly measured: MeasuredSettings | null;
  readonly start: () => void;
  readonly cancel: () => void;
}

/** What every setting costs for a level and run. */
export const accuracyQuestion = onDemand(jobs.accuracy);

/** Measures all settings in a worker on demand; the job ends when the component unmounts. */
export function useMeasured(): Measuring {
  const { desk } = useEditor();
  const { proof } = useLevel();
  const [measured, setMeasured] = useState<MeasuredSettings | null>(null);
  const accuracy = useMemo(() => accuracyQuestion(desk), [desk]);
  useEffect(() => accuracy.close, [accuracy]);
  const { phase, message } = useStore(accuracy.store);
  const start = useCallback(() => {
    const { level, terms, run, file } = proof.proof();
    const about = { level: level.name, run: run.name, played: { file, level }, holds: run.holds.join() };
    accuracy.ask({ level: withoutRuns(level), terms, holds: run.holds, methods: 'all' }, ({ answer }) => {
      if (answer !== null) setMeasured({ ...about, settings: answer.settings, knownTo: answer.knownTo });
    });
  }, [accuracy, proof]);
  const is = phase === 'asking' ? 'measuring' : phase === 'failed' ? 'failed' : 'idle';
  return { phase: is, message, measured, start, cancel: accuracy.forget };
}

interface DiagramOf {
  readonly level: string;
  readonly run: string | null;
  readonly settings: readonly Setting[];
  /** The setting in use, which is ringed. */
  readonly current: AccuracyName;
}

/** The work-precision diagram of a run as an SVG document. */
export function drawSettings({ level, run, settings, current }: DiagramOf, ground: Ground): string {
  const measured = settings.flatMap((setting) => {
    const accuracy = METHODS.find(({ name }) => name === setting.name);
    return accuracy === undefined ? [] : [{ ...setting, accuracy }];
  });
  const lines = linesOf(measured, ({ accuracy, error, cost, sameVerdict }) => ({
    error,
    worseError: null,
    cost,
    failures: sameVerdict ? 0 : 1,
    label: accuracy.name === current ? `${current}, in use` : null,
    note: isAccuracyName(accuracy.name) ? accuracy.name : accuracy.contact === 'swept' ? noteOf(accuracy) : null,
  }));
  const title = run === null ? `${level}: she drifts` : `${level}: ${run}`;
  const subtitle = ['Error and time of every setting for this level and run, measured in this browser.'];
  return drawDiagram({ title, subtitle, runs: 1, floor: 0, lines }, ground);
}
