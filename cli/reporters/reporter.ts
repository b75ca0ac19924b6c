import type { Terms } from '../../engine/basics/index.ts';
import type { CheckedLevel, Totals } from '../check/index.ts';
import type { Colors } from '../io/index.ts';
import type { CheckedPack } from '../pack-file/index.ts';
import type { EditorLink } from '../show-failure/index.ts';

/** The names of all reporters. */
export const REPORTER_NAMES = ['pretty', 'json', 'github', 'junit', 'sarif', 'markdown'] as const;

export type ReporterName = (typeof REPORTER_NAMES)[number];

/** What a check has found out. */
export interface Results {
  /** The levels that are listed: all, or of a large set those that fail. */
  readonly levels: readonly CheckedLevel[];
  /** The pack files that were checked with them; missing if there are none. */
  readonly packs?: readonly CheckedPack[];
  /** Of all levels. */
  readonly totals: Totals;
  /** How many levels that fail are not listed; missing if none. */
  readonly unlisted?: number;
  /** The files that were not checked, because the check ended early. */
  readonly unchecked: readonly string[];
  /** Whether a signal ended the check early. */
  readonly interrupted: boolean;
  /** The files that a report for people lists; all if it is left out. The summary is of all levels. */
  readonly shown?: ReadonlySet<string>;
  /** That there are more warnings than allowed; null or missing if there are not. */
  readonly excess?: string | null;
}

/** What a report depends on besides the results. */
export interface ReportContext {
  /** The colours of the report's destination. */
  readonly colors: Colors;
  /** The characters of a line of the report's destination; null: as many as it likes. */
  readonly width: number | null;
  /** The version of gq. */
  readonly version: string;
  /** Under which was checked. */
  readonly terms: Terms;
  readonly exitCode: number;
  /** Makes links to a page of the editor; null if none is known. */
  readonly linkTo: EditorLink | null;
  /** Whether reports for people leave out warnings and levels without errors. */
  readonly quiet?: boolean;
  readonly places: Places;
  /** Whether the report is for Jenkins, whose schema refuses an attribute that other readers of JUnit reports want. */
  readonly isJenkins: boolean;
}

/** Folders to which paths in reports are relative; absolute paths. */
export interface Places {
  /** The working directory. */
  readonly directory: string;
  /** The folder that GitHub takes for the root of the repository, under each name that is known; empty outside of GitHub. */
  readonly workspaces: readonly string[];
  /** The root of the repository; the working directory if there is none. */
  readonly root: string;
}

/** Makes a report. It depends on nothing else. */
export type Reporter = (results: Results, context: ReportContext) => string;
