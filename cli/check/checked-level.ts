import { termsReport } from '../../check/words/index.ts';
import type { Terms } from '../../engine/basics/index.ts';
import type { Allowed, Hold, RunReport, SoftlockReport, TermsReport, Verdict } from '../../schema/index.ts';
import { nameOfFile } from '../io/index.ts';
import type { Limits } from '../options/index.ts';
import type { ShownProblem } from '../report-parts/index.ts';

/** A run in brief: what a line about it, and a place in it, need. */
export interface RunInBrief extends Pick<RunReport, 'outcome' | 'time' | 'tick' | 'minerals' | 'clearance'> {
  /** Its name in the file; null if a search found it. */
  readonly name: string | null;
  /** Covers its motion bit for bit. Only with `forLock`; null if it would cost too much work. */
  readonly hash?: string | null;
  /** Its certified ticks, as a lock counts them. Only with `forLock`; null if it does not complete the level or costs too much work. */
  readonly certifiedTicks?: number | null;
  /** Where it stands in the file. Only with `forLock`; null if a search found it. */
  readonly place?: Pick<ShownProblem, 'pointer' | 'line' | 'column' | 'frame'> | null;
}

/** The results of `check` for one level file. */
export interface CheckedLevel {
  readonly file: string;
  /** The name of the level, or of the file if it is not a valid level. */
  readonly name: string;
  /** Under which terms all this holds. */
  readonly terms: TermsReport;
  readonly verdict: Verdict;
  /** The first run that completes the level, its own or one found by a search; else its first run. */
  readonly run: RunInBrief | null;
  /** The holds of that run if a search found it; else null. */
  readonly found: readonly Hold[] | null;
  /** The same run in full; null if the settings don't ask for it. */
  readonly report: RunReport | null;
  /** The number of minerals in the level. */
  readonly mineralCount: number;
  /** The problems that the level allows, by code; missing if it allows none. */
  readonly allow?: Allowed;
  /** How many problems were left out because it allows them. */
  readonly allowed?: number;
  /** Where it is already lost although she lives on. Only with `softlocks`; null if no run completes the level. */
  readonly softlocks?: SoftlockReport | null;
  readonly problems: readonly ShownProblem[];
  /** Whether the file itself could not be read. */
  readonly unreadable: boolean;
  /** ms of wall time for reading and replaying */
  readonly ms: number;
}

/** How to check a level. */
export interface CheckSettings {
  readonly terms: Terms;
  /** Whether runs are reported in full; the hash covers every sample and takes an eighth of the time of a check. */
  readonly inFull: boolean;
  /** Whether to find out what a lock compares: hash and certified ticks. Off by default, as it takes longer than the rest. */
  readonly forLock?: boolean;
  /** Whether to try to prove that minerals which no run collects can't be collected: takes up to 0.1 s for each level. */
  readonly proveMinerals: boolean;
  /** How to search if no run of the level completes it; null: not at all. */
  readonly search: SearchSettings | null;
  /** Ticks by which every press and release of each completing run must be allowed to move; null: no requirement. */
  readonly requireSlack: number | null;
  /** Ticks that the search for places where the level is already lost may take; absent: there is none. */
  readonly softlocks?: number;
}

/** How to search a level that none of its runs completes. */
export interface SearchSettings {
  /** The limits for each level. */
  readonly limits: Limits;
  readonly seed: number;
  /** The run that the search is said to have found: it is played, and nothing is searched. */
  readonly claimed?: readonly Hold[];
}

/** The report for a file that can't be read. */
export function unreadableLevel(file: string, message: string, terms: Terms): CheckedLevel {
  const hint = 'this level was not checked: make the file readable, or leave it out';
  return { ...refusedLevel(file, 'invalid', [problemOfFile('unreadable-file', message, hint)], terms), unreadable: true };
}

/** The report for a level that makes the toolkit itself fail. */
export function crashedLevel(file: string, error: unknown, terms: Terms): CheckedLevel {
  const message = `checking this level crashed: ${error instanceof Error ? error.message : String(error)}`;
  const problem = problemOfFile('crashed', message, 'this is a bug in gq: please report it, with the level file');
  return refusedLevel(file, 'crashed', [problem], terms);
}

const problemOfFile = (code: string, message: string, hint: string): ShownProblem => ({
  code,
  severity: 'error',
  message,
  hint,
  pointer: '',
  line: null,
  column: null,
  frame: null,
});

/** The report for a file of which only the problems are known. */
export function refusedLevel(
  file: string,
  verdict: 'invalid' | 'crashed',
  problems: readonly ShownProblem[],
  terms: Terms,
): CheckedLevel {
  return {
    file,
    name: nameOfFile(file),
    terms: termsReport({ terms, level: terms }),
    verdict,
    run: null,
    found: null,
    report: null,
    mineralCount: 0,
    problems,
    unreadable: false,
    ms: 0,
  };
}

/**
 * Says of each problem where it is in a way that survives changes elsewhere in the file: its pointer with ids of objects and
 * names of runs in place of indices.
 * @param text the file
 */
export function withKeys(problems: readonly ShownProblem[], text: string, content?: unknown): ShownProblem[] {
  const document = problems.some(({ pointer }) => /\/\d/.test(pointer)) ? (content ?? parsed(text)) : null;
  return problems.map((problem) => ({ ...problem, key: keyOf(problem.pointer, document) }));
}

/** The key of a pointer into a document; entries of lists without an id or a name are all alike. */
export function keyOf(pointer: string, document: unknown): string {
  let value = document;
  const steps = pointer.split('/').map((step, i) => {
    if (i === 0) return '';
    const inner = insideOf(value, step);
    const isIndex = value === undefined || value === null ? /^\d+$/.test(step) : Array.isArray(value);
    value = inner;
    return isIndex ? nameOf(inner) : step;
  });
  return steps.join('/');
}

function insideOf(value: unknown, step: string): unknown {
  if (typeof value !== 'object' || value === null) return undefined;
  const key = step.replaceAll('~1', '/').replaceAll('~0', '~');
  return Object.hasOwn(value, key) ? (value as Record<string, unknown>)[key] : undefined;
}

function nameOf(entry: unknown): string {
  if (typeof entry !== 'object' || entry === null) return '*';
  const { id, name } = entry as { readonly id?: unknown; readonly name?: unknown };
  const known = typeof id === 'string' ? id : typeof name === 'string' ? name : null;
  return known === null ? '*' : `=${known.replaceAll('~', '~0').replaceAll('/', '~1')}`;
}

/** The content of a file; null if it is not JSON. */
function parsed(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
