import { useCallback, useEffect, useMemo, useState } from 'react';
import { useStore } from 'zustand';
import { question } from '../../core/ask/index.ts';
import { useEditor, useLevel } from '../../core/context/index.ts';
import { type PlayedFile, withoutRuns } from '../../core/proof/index.ts';
import { type AskedOf, jobs, type Setting } from '../../workers/index.ts';

/** The measured cost of all settings for one level and run. */
export interface MeasuredSettings {
  readonly settings: readonly Setting[];
  readonly level: string;
  readonly run: string | null;
  readonly played: PlayedFile;
  readonly holds: string;
}

export interface Measuring {
  readonly phase: 'idle' | 'measuring' | 'failed';
  readonly message: string | null;
  readonly measured: MeasuredSettings | null;
  readonly start: () => void;
  readonly cancel: () => void;
}

/** What every setting costs for a level and run. */
export const accuracyQuestion = question({ job: jobs.accuracy, request: (of: AskedOf<typeof jobs.accuracy>) => of });

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
    accuracy.ask({ level: withoutRuns(level), terms, holds: run.holds }, ({ answer }) => {
      if (answer !== null) setMeasured({ ...about, settings: answer.settings });
    });
  }, [accuracy, proof]);
  const is = phase === 'asking' ? 'measuring' : phase === 'failed' ? 'failed' : 'idle';
  return { phase: is, message, measured, start, cancel: accuracy.forget };
}
