import { realpathSync } from 'node:fs';
import { isAbsolute, relative, resolve, sep } from 'node:path';
import type { Terms } from '../../engine/basics/index.ts';
import type { CheckedLevel, Totals } from '../check/index.ts';
import { entryName, repositoryOf } from '../io/index.ts';
import type { CheckedPack } from '../pack-file/index.ts';
import type { EditorLink } from '../show-failure/index.ts';
import type { Colors } from '../terminal/index.ts';

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

/** The folders to which paths in reports are relative. */
export function placesOf(directory: string, { GITHUB_WORKSPACE }: NodeJS.ProcessEnv): Places {
  const given = GITHUB_WORKSPACE ? [resolve(directory, GITHUB_WORKSPACE)] : [];
  return { directory, workspaces: [...new Set(given.flatMap((path) => [path, real(path)]))], root: repositoryOf(directory) };
}

/** A working directory is known by its real path, while a variable may name a link to it. */
function real(path: string): string {
  try {
    return realpathSync(path);
  } catch {
    return path;
  }
}

const withSlashes = (path: string): string => (sep === '/' ? path : path.split(sep).join('/'));

/** A path relative to the first of some folders that contains it, with slashes; null if none does. */
function below(folders: readonly string[], file: string, directory: string): string | null {
  // the name of an entry of a pack is no path: dots in it lead nowhere
  const { pack, label } = entryName(file) ?? { pack: file, label: null };
  for (const folder of folders) {
    const path = relative(folder, resolve(directory, pack));
    const isOutside = path === '' || path === '..' || path.startsWith(`..${sep}`) || isAbsolute(path);
    if (!isOutside) return label === null ? withSlashes(path) : `${withSlashes(path)}#${label}`;
  }
  return null;
}

/** A path as GitHub wants it: relative to its workspace; else as it was given. */
export const pathInWorkspace = (file: string, { workspaces, directory }: Places): string =>
  below(workspaces, file, directory) ?? withSlashes(file);

/** What a service takes for the root of the repository: GitHub's workspace, else the repository itself. */
export const rootOf = ({ workspaces, root }: Places): string => workspaces[0] ?? root;

/** A path relative to that root; null if it is outside. */
export const pathInRepository = (file: string, { workspaces, root, directory }: Places): string | null =>
  below(workspaces.length > 0 ? workspaces : [root], file, directory);
