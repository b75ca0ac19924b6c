import { readText } from '../../editor/core/files/index.ts';
import {
  createProver,
  type FoundByWorker,
  knownProblems,
  knownVerdict,
  type LiveProof,
  type Proved,
  toPlay,
  toProve,
} from '../../editor/core/proof/index.ts';
import type { JobKind, Requests, Results } from '../../editor/workers/index.ts';
import { JOBS } from '../../editor/workers/runner.ts';
import type { Terms } from '../../engine/index.ts';
import type { Problem } from '../../schema/index.ts';

/** What is said of a level in either place: everything but hints. */
export interface Said {
  readonly verdict: string;
  readonly problems: readonly Omit<Problem, 'hint'>[];
}

/** Does a job as a worker does, at once. */
function work<K extends JobKind>(kind: K, request: Requests[K]): Results[K] {
  const steps = JOBS[kind](request, () => 0);
  for (;;) {
    const step = steps.next();
    if (step.done === true) return step.value;
  }
}

/** As it comes back from a worker. */
const sent = <T>(message: T): T => structuredClone(message);

const NOTHING: Proved = { impossible: null, minerals: [], isWhole: true };

/** What a worker finds where the page has left something out; null when it has not. */
function foundByWorker(proof: LiveProof): FoundByWorker | null {
  const question = toPlay(proof);
  return question === null ? null : { result: sent(work('check', question)), message: '' };
}

function proved(proof: LiveProof): Proved {
  const question = toProve(proof);
  return question === null ? NOTHING : { ...sent(work('proofs', sent(question))), isWhole: true };
}

const shown = ({ code, severity, message, pointer, line, column }: Problem): Said['problems'][number] => {
  return { code, severity, message, pointer, line, column };
};

export interface OnThePage {
  /** The work that the page does itself, pieces of motion. */
  readonly most?: number;
}

/**
 * What the page says of a level file under some terms: its verdict in the top bar, and its list of problems in the words of the panel, once all
 * workers are done.
 */
export function onThePage(source: string | Uint8Array, terms: Terms, { most }: OnThePage = {}): Said {
  const read = readText(source);
  if (!read.ok) return { verdict: 'invalid', problems: read.problems.map(shown) };
  // A clock that stands still, so that nothing is abandoned because this machine is slow.
  const proof = createProver(() => 0, most).prove({ file: read.file, run: null, terms, patience: 1 });
  const worker = foundByWorker(proof);
  const known = proved(proof);
  return { verdict: knownVerdict(proof, worker, known), problems: knownProblems(proof, worker, known).map(shown) };
}

/** The verdict that the list of levels shows beside a file's picture. */
export const inTheList = (text: string, terms: Terms): string =>
  work('thumbnail', { text, terms, width: 100, theme: 'dark' }).verdict;
