import type { Hold } from '../../schema/index.ts';
import { type Desk, question } from '../ask/index.ts';
import type { LiveProof, ProofStore } from '../proof/index.ts';
import { jobs, type Retiming } from '../workers/index.ts';
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

/** Small shifts of a run with which it completes the level as it is. */
export const retimeQuestion = question({
  job: jobs.retime,
  request: ({ about, former, warm, effort, certifies }: Question & { readonly about: LiveProof }) => ({
    level: about.level,
    terms: about.terms,
    holds: former.holds,
    minerals: indicesOf(about.file, former.minerals),
    ...{ warm, within: WITHIN, formerEnd: former.tick, effort, certifies },
  }),
});

/** Asks a worker. */
export function createHoldSeeker(proof: ProofStore, desk: Desk): HoldSeeker {
  const retiming = retimeQuestion(desk);
  return {
    ask(asked, hear) {
      const about = proof.proof();
      retiming.ask({ ...asked, about }, ({ phase, progress, answer }) => {
        const isLast = phase !== 'asking';
        hear({ ...((isLast ? answer : progress) ?? NOTHING), about, isLast });
      });
    },
    stop: retiming.forget,
    about: () => retiming.store.getState().of?.about ?? null,
    get isBusy() {
      return retiming.store.getState().phase === 'asking';
    },
  };
}
