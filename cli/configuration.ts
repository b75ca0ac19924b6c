import { resolve } from 'node:path';
import type { AccuracyName } from '../engine/index.ts';
import type { OwnRules, ReporterName, SeverityMap } from '../schema/index.ts';

/** A report, and where it goes. */
export interface ReporterChoice {
  readonly name: ReporterName;
  /** The file to write, as the working directory sees it; null: stdout. */
  readonly file: string | null;
}

/** What `gq.config.json` sets. Its paths are turned into those that the working directory sees; null: not set. */
export interface Configuration {
  /** The file, as the working directory sees it; null without a configuration. */
  readonly file: string | null;
  /** Its directory, absolute; the working directory without a configuration. Patterns of `ignore` are relative to it. */
  readonly directory: string;
  readonly levels: readonly string[] | null;
  /** As written in the file. */
  readonly ignore: readonly string[];
  readonly accuracy: AccuracyName | null;
  /** s */
  readonly maxTime: number | null;
  /** Pieces of motion. */
  readonly maxWork: number | null;
  readonly requireSlack: number | null;
  readonly severity: SeverityMap;
  readonly maxWarnings: number | null;
  readonly reporters: readonly ReporterChoice[] | null;
  readonly lock: string | null;
  /** true or false: whether to keep results; a text: the directory for them. */
  readonly cache: boolean | string | null;
  readonly rules: OwnRules;
}

/** What holds without a configuration. */
export const noConfiguration = (): Configuration => ({
  file: null,
  directory: resolve(''),
  levels: null,
  ignore: [],
  accuracy: null,
  maxTime: null,
  maxWork: null,
  requireSlack: null,
  severity: {},
  maxWarnings: null,
  reporters: null,
  lock: null,
  cache: null,
  rules: {},
});
