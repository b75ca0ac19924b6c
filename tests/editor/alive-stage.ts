import { createEditedLevel } from '../../editor/core/document/index.ts';
import { createProofStore } from '../../editor/core/proof/index.ts';
import { createSettings } from '../../editor/core/settings/index.ts';
import { aliveOf } from '../../editor/features/alive/index.ts';
import { keepAlive } from '../../editor/features/alive/keep-alive.ts';
import type { JobEnd, Requests, Results, Workers } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import { compile, DEFAULT_TERMS, joinHolds, simulate } from '../../engine/index.ts';
import { type LevelFile, resolveLevel } from '../../schema/index.ts';

/** One job that was asked for and is not done. */
interface Waiting {
  readonly request: Requests['retime'];
  readonly tell: (progress: Results['retime']) => void;
  readonly end: (end: JobEnd<Results['retime']>) => void;
}

/** A level that is kept alive, with a worker that works when a test says so. */
export function aliveStage(file: LevelFile, { isOn = true } = {}) {
  const document = createEditedLevel(file);
  const proof = createProofStore(document, DEFAULT_TERMS);
  const settings = createSettings(null);
  settings.setState({ keepAlive: isOn });
  let waiting: Waiting[] = [];
  let rests: (() => void)[] = [];
  const start = (_: 'retime', request: Requests['retime'], tell: Waiting['tell']) => {
    let end: Waiting['end'] = () => {};
    const ended = new Promise<JobEnd<Results['retime']>>((resolve) => {
      end = resolve;
    });
    const mine: Waiting = { request, tell, end };
    waiting.push(mine);
    const cancel = () => {
      waiting = waiting.filter((other) => other !== mine);
      end({ kind: 'cancelled' });
    };
    return { end: ended, cancel };
  };
  const workers = { start: start as never as Workers['start'] };
  const afterRest = (_: number, call: () => void) => {
    rests.push(call);
    return () => {
      rests = rests.filter((other) => other !== call);
    };
  };
  const level = { document, proof };
  const stop = keepAlive({ level, settings, desk: { workers, afterRest, after: afterRest } });
  const breathe = async () => {
    for (let i = 0; i < 4; i++) await Promise.resolve();
  };
  /** The worker does what it was asked for first. @returns whether there was something */
  const work = async (): Promise<boolean> => {
    const [job] = waiting;
    if (job === undefined) return false;
    // messages are copied on their way
    const steps = JOBS.retime(structuredClone(job.request), () => 0);
    for (let step = steps.next(); waiting[0] === job; step = steps.next()) {
      if (step.done === true) {
        waiting.shift();
        job.end({ kind: 'done', result: structuredClone(step.value) });
        break;
      }
      if (step.value !== null) job.tell(structuredClone(step.value));
    }
    await breathe();
    return true;
  };
  /** The worker that was asked first dies. */
  const die = async (): Promise<void> => {
    waiting.shift()?.end({ kind: 'failed', message: 'the worker died' });
    await breathe();
  };
  return {
    document,
    proof,
    settings,
    store: aliveOf(level),
    stop,
    work,
    die,
    jobs: () => waiting.length,
    asked: () => waiting.map(({ request }) => request),
    /** The page comes to rest. */
    rest: async () => {
      const due = rests;
      rests = [];
      for (const call of due) call();
      await breathe();
    },
    /** Everything that is asked for is done, and the page rests. */
    settle: async () => {
      for (let i = 0; i < 50; i++) {
        while (await work());
        if (rests.length === 0) return;
        const due = rests;
        rests = [];
        for (const call of due) call();
      }
    },
  };
}

/** How a run of a file ends, as `gq simulate` says it. */
export function outcomeOf(file: LevelFile, name: string): string {
  const level = resolveLevel(structuredClone(file));
  const run = level.runs.find((one) => one.name === name);
  if (run === undefined) throw new Error(name);
  return simulate(compile(level), joinHolds(run.holds)).outcome;
}
