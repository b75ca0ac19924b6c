import {
  examineRuns,
  type LostMineral,
  mineralsToProve,
  playRuns,
  proofBudget,
  proveGoalImpossible,
  proveMineralsLost,
  type RunFindings,
} from '../../../check/index.ts';
import { compile, maxTicksOf, type Scene, WorkBudget } from '../../../engine/index.ts';
import { createAnytimeProof, type Proof, type ProofPicture, proofPicture } from '../../../solver/index.ts';
import { accuracyNameOf, job, type Played, type Work } from '../job.ts';

/** The findings of all runs of a level. */
export const check = job<Played, RunFindings>({ name: 'check', lane: 'quick', most: 20_000 });

/** The findings of a level's runs, simulated as far as `gq check` does: for levels that would block the page. */
export const checkWork: Work<typeof check> = {
  of: check,
  *steps({ level, terms }) {
    yield null;
    const scene = compile(level, terms);
    const budget = new WorkBudget(terms.maxWork);
    const runs = playRuns(scene, budget);
    yield null;
    return examineRuns(level, runs, { scene, budget });
  },
};

/** What is proved, confirmed by the separate checker; null and empty: nothing is. */
export interface Proofs {
  readonly impossible: Proof | null;
  readonly minerals: readonly LostMineral[];
  /** How the first proof looks, if that was asked for; null: there is none. */
  readonly picture?: ProofPicture | null;
}

/** Proves, if possible, that no run reaches the black hole or a mineral. */
export const proofs = job<
  Played & {
    /** Minerals that some run collects, which are left out; null: the level's runs are simulated to find out. */
    readonly collected: readonly number[] | null;
    /** How long to go on with ever finer sets, ms; 0 if absent. */
    readonly finer?: number;
    /** Whether a picture of the first proof is wanted; false if absent. */
    readonly isDrawn?: boolean;
  },
  Proofs,
  Proofs
>({ name: 'proofs', lane: 'long', most: 20_000 });

/** Ticks between two looks at the clock. */
const SLICE = 50_000;

/**
 * Proves what can't be reached, with as much work as `gq check` allows, and then for `finer` ms with ever finer sets that the
 * black hole can't be. Every result is confirmed by the separate checker.
 */
export const proofsWork: Work<typeof proofs> = {
  of: proofs,
  *steps({ level, terms, collected, finer = 0, isDrawn = false }, now) {
    const end = now() + finer;
    const scene = compile(level, terms);
    const budget = proofBudget(scene);
    let drawn: { readonly of: Proof | null; readonly picture: ProofPicture | null } = { of: null, picture: null };
    const proved = (impossible: Proof | null, minerals: readonly LostMineral[]): Proofs => {
      const of = impossible ?? minerals[0]?.proof ?? null;
      if (isDrawn && of !== drawn.of) drawn = { of, picture: of && proofPicture(level, of) };
      return isDrawn ? { impossible, minerals, picture: drawn.picture } : { impossible, minerals };
    };
    const impossible = proveGoalImpossible(scene, { minerals: 'any' }, budget);
    yield proved(impossible, []);
    const asked = mineralsToProve(level, collected ?? collectedIn(scene));
    const minerals = proveMineralsLost(scene, asked, budget);
    if (impossible !== null) return proved(impossible, minerals);
    yield proved(null, minerals);
    const isStopped = () => now() >= end;
    const proving = createAnytimeProof(level, { accuracy: accuracyNameOf(terms), maxTicks: maxTicksOf(terms), isStopped });
    while (!proving.finished && !isStopped()) {
      proving.advance(SLICE);
      yield null;
    }
    return proved(proving.proof, minerals);
  },
};

/** Indices of the minerals that some run of the level collects. */
const collectedIn = (scene: Scene): number[] =>
  playRuns(scene, new WorkBudget(scene.terms.maxWork)).flatMap(({ minerals }) => minerals.map(({ index }) => index));
