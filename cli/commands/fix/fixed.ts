import { brief, type LevelVerdict, repairedFile } from '../../../check/index.ts';
import { compile, type Run, simulate, type Terms } from '../../../engine/index.ts';
import { formatLevel, type LevelFile, readLevel } from '../../../schema/index.ts';
import { createRepair, type Effort, type Proof, type Proposal } from '../../../solver/index.ts';
import type { OpenedFile } from '../../levels/index.ts';
import type { Limits } from '../../options/index.ts';
import { DEFAULT_NAME, freeName } from '../../solve/index.ts';

/** What to look for. */
export interface FixSettings {
  readonly terms: Terms;
  readonly count: number;
  readonly seed: number;
  readonly limits: Limits;
}

/** A proposal with the file that it leads to, and the run that completes the level of that file. */
export interface FixedFile {
  readonly proposal: Proposal;
  readonly file: LevelFile;
  readonly run: Run;
}

/** What was found for a level. */
export interface Fixed {
  readonly verdict: LevelVerdict;
  /** Index of a run that completes the level as it is; null if none does. */
  readonly completing: number | null;
  readonly impossible: Proof | null;
  /** The smallest first. */
  readonly fixes: readonly FixedFile[];
  readonly effort: Effort;
  /** s of wall time */
  readonly seconds: number;
  readonly isFinished: boolean;
}

/** Simulated ticks between two looks at the clock. */
const SLICE = 20_000;

/**
 * Seeks changes that make a level completable. Blocks the calling thread for as long as the limits allow.
 * @param onSlice called now and then with what has been found so far
 */
export function fixLevel(opened: OpenedFile, settings: FixSettings, onSlice: (found: number, ticks: number) => void): Fixed {
  const { level } = opened;
  const { terms, count, seed, limits } = settings;
  const start = performance.now();
  const end = limits.budget === null ? Number.POSITIVE_INFINITY : start + 1000 * limits.budget;
  const most = limits.effort ?? Number.POSITIVE_INFINITY;
  const { verdict, impossible } = brief(level, terms);
  const repair = createRepair(level, terms, { count, seed, proof: impossible });
  while (!repair.finished && repair.effort.ticks < most && (performance.now() < end || repair.effort.ticks === 0)) {
    repair.advance(Math.min(SLICE, most - repair.effort.ticks));
    onSlice(repair.proposals.length, repair.effort.ticks);
  }
  const { completing, finished } = repair;
  return {
    verdict,
    completing,
    impossible,
    fixes: repair.proposals.map((proposal) => fixedFile(opened, proposal, settings)),
    effort: { ...repair.effort },
    seconds: (performance.now() - start) / 1000,
    isFinished: finished,
  };
}

/** Makes the file of a proposal, reads it again as it would be written, and replays the run in it. */
function fixedFile({ document, level }: OpenedFile, proposal: Proposal, { terms }: FixSettings): FixedFile {
  const name = freeName(
    DEFAULT_NAME,
    level.runs.map((run) => run.name),
  );
  const file = repairedFile(document.file, proposal, name);
  const read = readLevel(formatLevel(file), terms);
  if (!read.ok) throw new Error(`a proposal makes the file invalid: ${read.problems[0].message}`);
  const run = simulate(compile(read.level, terms), proposal.run.holds);
  if (run.outcome !== 'completed') throw new Error(`a proposal does not make the level completable: ${JSON.stringify(proposal)}`);
  return { proposal, file, run };
}
