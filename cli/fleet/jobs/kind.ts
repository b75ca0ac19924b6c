import type { CommandResult } from '../../command.ts';
import type { Destination, ReporterName } from '../../reporters/index.ts';
import type { EditorLink } from '../../show-failure/index.ts';
import type { Json, ShardRecord, Work } from '../job.ts';

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
   * @param records gives the records in the order of the set, as often as it is called
   * @param reporting as the plan has it
   */
  report(
    records: () => Iterable<ShardRecord>,
    reporting: Json,
    destinations: readonly Destination[],
    options: ReportOptions,
  ): CommandResult | Promise<CommandResult>;
}
