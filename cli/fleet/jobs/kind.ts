import process from 'node:process';
import type { CommandResult, ResultFile } from '../../command.ts';
import { inPieces } from '../../report-parts/index.ts';
import type { Destination, ReporterName } from '../../reporters/index.ts';
import type { EditorLink } from '../../show-failure/index.ts';
import { type Colors, colorsFor, PLAIN, widthOf } from '../../terminal/index.ts';
import type { Json, Records, Work } from '../job.ts';

/** Options of a report that do not come from the plan. */
export interface ReportOptions {
  /** Makes links to a page of the editor. */
  readonly linkTo?: EditorLink | null;
  readonly quiet?: boolean;
  /** Whether levels have the time that they took, which is another in each run. */
  readonly withTimes: boolean;
}

/** What can be done with a set. Loads little: what simulates is loaded by `openWork`. */
export interface JobKind {
  /** The reports that it can make. */
  readonly formats: readonly ReporterName[];
  /** Whether an entry may take seconds. */
  isLong(settings: Json): boolean;
  /** Whether a record claims something good, which a replay can refute. */
  isClaim(result: Json): boolean;
  /**
   * Looks at what results depend on besides the set.
   * @throws Failure if it is not as the settings say
   */
  expectInputs?(settings: Json): Promise<void>;
  /** What is recorded for an entry on which a thread has died. @param settings as the plan has them */
  crashed(name: string, error: unknown, settings: Json): Json;
  /** Loads what a thread does. @param settings as the plan has them */
  openWork(settings: Json): Promise<Work>;
  /**
   * Makes the reports.
   * @param reporting as the plan has it
   */
  report(
    records: Records,
    reporting: Json,
    destinations: readonly Destination[],
    options: ReportOptions,
  ): CommandResult | Promise<CommandResult>;
}

/** With more entries than this, reports for people list only those that fail, and only so many of them. */
const MOST_LISTED = 1000;

/** Collects what a report for people lists of a set: all of a small one; of a large one, those that fail. */
export class Listed<T> {
  private readonly first: T[] = [];
  private readonly failing: T[] = [];
  private count = 0;
  private failed = 0;

  add(item: T, isGood: boolean): void {
    this.count++;
    if (this.first.length <= MOST_LISTED) this.first.push(item);
    if (isGood) return;
    this.failed++;
    if (this.failing.length < MOST_LISTED) this.failing.push(item);
  }

  get isSmall(): boolean {
    return this.count <= MOST_LISTED;
  }

  get items(): readonly T[] {
    return this.isSmall ? this.first : this.failing;
  }

  /** How many that fail are not listed. */
  get unlisted(): number {
    return this.isSmall ? 0 : this.failed - this.failing.length;
  }
}

/** What a report for people says of those that it does not list; '' if there are none. */
export const unlistedInWords = (unlisted: number): string =>
  unlisted === 0 ? '' : `and ${unlisted} more that fail: --format json lists all\n`;

/**
 * A record has the verdict that a thread gave, unless somebody has changed it since.
 * @throws Error if it is none
 */
export function expectVerdict(found: unknown, known: readonly unknown[]): void {
  if (!known.includes(found)) throw new Error(`expected a verdict, found ${JSON.stringify(found) ?? 'none'}`);
}

/** The reports of the jobs that have no reporters of their own. */
export const PLAIN_FORMATS: readonly ReporterName[] = ['pretty', 'json'];

/**
 * Makes reports for people and as JSON.
 * @param json gives the pieces of the report, as often as it is called
 */
export function plainReport(
  destinations: readonly Destination[],
  { json, pretty }: { readonly json: () => Iterable<string>; pretty(colors: Colors, width: number | null): string },
): Required<Pick<CommandResult, 'output' | 'files'>> {
  const make = (name: ReporterName, colors: Colors, width: number | null): string | Iterable<string> =>
    name === 'json' ? inPieces(json) : pretty(colors, width);
  const files: ResultFile[] = [];
  let output: string | Iterable<string> = '';
  for (const { name, file } of destinations) {
    if (!PLAIN_FORMATS.includes(name)) throw new Error(`there is no report ${name} of this job`);
    if (file === null) output = make(name, colorsFor(process.stdout), widthOf(process.stdout));
    else files.push({ path: file, content: make(name, PLAIN, null), mode: 'replace' });
  }
  return { output, files };
}
