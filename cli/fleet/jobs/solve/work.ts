import { plural } from '../../../../check/words/index.ts';
import { type Level, readLevel, type SolveReport } from '../../../../schema/index.ts';
import { type Entry, nameOfFile } from '../../../io/index.ts';
import { showProblems } from '../../../report-parts/index.ts';
import { replayRuns, settingsFor, solveHere, solveReport } from '../../../solve/index.ts';
import { type Json, oneByOne, type Work } from '../../job.ts';
import { type SolveJobSettings, type SolveRecord, type SolveVerdict, untried } from './record.ts';

/** Solves levels. */
export function openSolve(settings: SolveJobSettings): Work {
  return {
    work: oneByOne(async (entry) => (await solveEntry(entry, settings)) as unknown as Json),
    replay: (entry, result) => whyNotAsRecorded(entry, settings, result as unknown as SolveRecord),
  };
}

async function solveEntry({ name, content }: Entry, settings: SolveJobSettings): Promise<SolveRecord> {
  if (!(content instanceof Uint8Array)) return { ...untried(name, 'invalid', content.message), unreadable: true };
  const read = readLevel(content, settings.terms);
  if (!read.ok) {
    return { ...untried(nameOfFile(name), 'invalid', 'not a valid level'), problems: showProblems(read.problems, read.text) };
  }
  const { level } = read;
  const few = whyTooFewMinerals(level, settings);
  if (few !== null) return untried(level.name, 'not-found', few);
  const asked = settingsFor(level, settings);
  const solved = await solveHere(asked, settings.limits);
  const verdict = solved.impossible !== null ? 'impossible' : solved.runs.length > 0 ? 'found' : 'not-found';
  // time would be another on each machine
  return tried(level, verdict, solveReport(asked, { ...solved, seconds: 0 }));
}

const tried = ({ name }: Level, verdict: SolveVerdict, solved: SolveReport): SolveRecord => ({
  ...untried(name, verdict, ''),
  solved,
  why: null,
});

function whyTooFewMinerals({ minerals }: Level, { goal }: SolveJobSettings): string | null {
  if (typeof goal.minerals !== 'number' || goal.minerals <= minerals.length) return null;
  return `it has only ${plural(minerals.length, 'mineral')} of the ${goal.minerals} required`;
}

/** A search is not repeated: the runs that it has found are replayed and measured. */
function whyNotAsRecorded({ content }: Entry, settings: SolveJobSettings, record: SolveRecord): string | null {
  const read = content instanceof Uint8Array ? readLevel(content, settings.terms) : null;
  if (!read?.ok) return 'not a valid level';
  const { solved } = record;
  if (solved === null) return 'not solved';
  const asked = settingsFor(read.level, settings);
  const claimed = solved.solutions ?? [solved];
  const runs = replayRuns(
    asked,
    claimed.map(({ holds }) => holds ?? []),
  );
  if (runs === null) return 'a run that does not reach the goal';
  const { effort } = solved;
  const again = solveReport(asked, { runs, effort, seconds: effort.seconds, closest: null, impossible: null });
  return JSON.stringify(tried(read.level, 'found', again)) === JSON.stringify(record) ? null : 'solved, but not as recorded';
}
