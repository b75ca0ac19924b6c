import type { Hold } from '../../schema/index.ts';
import type { LiveProof, ProofStore } from '../proof/index.ts';
import { jobs, type Results, type Retiming, type Running, type Workers } from '../workers/index.ts';
import { type Former, indicesOf } from './former.ts';

/** No press or release is shifted farther than this, ticks: it would be another run. */
export const WITHIN = 90;

/** What is asked. */
interface Question {
  readonly former: Former;
  /** Holds that worked a moment ago; null: none. */
  readonly warm: readonly Hold[] | null;
  /** ticks */
  readonly effort: number;
  readonly certifies: boolean;
}

/** An answer, which may be about a level that has changed since. */
export interface Answer extends Retiming {
  /** The level that it is about. */
  readonly about: LiveProof;
  readonly isLast: boolean;
}

/** Seeks holds with which runs complete the level as it is, one question at a time: the latest one wins. */
export interface HoldSeeker {
  ask(question: Question, hear: (answer: Answer) => void): void;
  stop(): void;
  /** The level that is or was asked about last; null if nothing was asked since it was stopped. */
  about(): LiveProof | null;
  readonly isBusy: boolean;
}

const NOTHING: Retiming = { best: null, effort: { runs: 0, ticks: 0 }, finished: false };

/** Asks a worker. */
export function createHoldSeeker(proof: ProofStore, workers: Pick<Workers, 'start'>): HoldSeeker {
  let job: Running<Results['retime']> | null = null;
  let about: LiveProof | null = null;
  return {
    ask({ former, warm, effort, certifies }, hear) {
      job?.cancel();
      const now = proof.proof();
      about = now;
      const { level, terms } = now;
      const minerals = indicesOf(now.file, former.minerals);
      const request = { level, terms, holds: former.holds, minerals, warm, within: WITHIN, formerEnd: former.tick };
      const mine = workers.start(jobs.retime, { ...request, effort, certifies }, (found) => {
        if (job === mine) hear({ ...found, about: now, isLast: false });
      });
      job = mine;
      void mine.end.then((end) => {
        if (job !== mine) return;
        job = null;
        hear({ ...(end.kind === 'done' ? end.result : NOTHING), about: now, isLast: true });
      });
    },
    stop() {
      job?.cancel();
      job = null;
      about = null;
    },
    about: () => about,
    get isBusy() {
      return job !== null;
    },
  };
}
