import { useCallback, useEffect, useRef, useState } from 'react';
import { useEditor, useLevel } from '../../context/index.ts';
import type { PlayedFile } from '../../proof/index.ts';
import { jobs, type Results, type Running, type Setting } from '../../workers/index.ts';

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

/** Measures all settings in a worker on demand; the job ends when the component unmounts. */
export function useMeasured(): Measuring {
  const { workers } = useEditor();
  const { proof } = useLevel();
  const [state, setState] = useState<Pick<Measuring, 'phase' | 'message' | 'measured'>>({
    phase: 'idle',
    message: null,
    measured: null,
  });
  const job = useRef<Running<Results['accuracy']> | null>(null);
  const drop = useCallback(() => {
    job.current?.cancel();
    job.current = null;
  }, []);
  useEffect(() => drop, [drop]);
  const start = useCallback(() => {
    drop();
    const { level, terms, run, file } = proof.proof();
    const about = { level: level.name, run: run.name, played: { file, level }, holds: run.holds.join() };
    const mine = workers.start(jobs.accuracy, { level: { ...level, runs: [] }, terms, holds: run.holds });
    job.current = mine;
    setState(({ measured }) => ({ phase: 'measuring', message: null, measured }));
    void mine.end.then((end) => {
      if (job.current !== mine) return;
      if (end.kind === 'failed' || end.kind === 'gaveUp')
        setState(({ measured }) => ({ phase: 'failed', message: end.message, measured }));
      if (end.kind === 'done') setState({ phase: 'idle', message: null, measured: { ...about, settings: end.result.settings } });
    });
  }, [drop, proof, workers]);
  const cancel = useCallback(() => {
    drop();
    setState(({ measured }) => ({ phase: 'idle', message: null, measured }));
  }, [drop]);
  return { ...state, start, cancel };
}
