import { join } from 'node:path';
import { plural } from '../../../check/words/index.ts';
import type { BuildReport } from '../../../schema/index.ts';
import { type BuiltPack, isUnplayable, type SiteFile, whyRefused } from '../../build/index.ts';
import { problemJson, showFileProblems } from '../../report-parts/index.ts';
import { type Colors, shellPath, visibleLine } from '../../terminal/index.ts';

type Levels = BuiltPack['levels'];

export interface BuildResult {
  readonly site: string;
  readonly title: string;
  readonly levels: Levels;
  /** The ids of levels that a pack.json does not list. */
  readonly leftOut: readonly string[];
  /** The levels because of which nothing was written. */
  readonly refused: Levels;
  readonly files: readonly SiteFile[];
  /** Bytes of all files as a server sends them. */
  readonly gzipped: number;
}

const sizeOf = (files: readonly SiteFile[]): number => files.reduce((sum, { bytes }) => sum + bytes, 0);

/** The results of `build` as JSON. */
export function buildJson({ site, title, levels, leftOut, refused, files, gzipped }: BuildResult): string {
  const report: BuildReport = {
    version: 1,
    written: refused.length === 0,
    site,
    title,
    levels: levels.map(({ id, file, name, terms, verdict, problems }) => ({
      id,
      file,
      name,
      terms,
      verdict,
      refused: refused.some((one) => one.id === id),
      problems: problems.map(problemJson),
    })),
    ...(leftOut.length > 0 && { leftOut: [...leftOut] }),
    files: files.map(({ file, status, bytes }) => ({ file, status, bytes })),
    bytes: sizeOf(files),
    gzipped,
  };
  return `${JSON.stringify(report)}\n`;
}

const kilobytes = (bytes: number): string => `${Math.max(1, Math.round(bytes / 1000)).toLocaleString('en')} kB`;

/** The results of `build` for people. */
export function buildPretty({ site, title, levels, leftOut, files, gzipped }: BuildResult): string {
  const changed = files.filter(({ status }) => status !== 'unchanged');
  const lines = changed.map(({ file, status }) => `${status} ${visibleLine(file)}`);
  if (changed.length < files.length) lines.push(`unchanged: ${plural(files.length - changed.length, 'other file')}`);
  if (leftOut.length > 0) lines.push(`left out, as pack.json does not list them: ${leftOut.map(visibleLine).join(', ')}`);
  const folder = shellPath(site);
  return `${lines.join('\n')}
“${visibleLine(title)}”: ${plural(levels.length, 'level')}, ${kilobytes(sizeOf(files))} (${kilobytes(gzipped)} compressed)

next:
  open ${shellPath(join(site, 'index.html'))} in a browser: it needs no server
  npx --yes serve ${folder}, to try it as a web server sends it
  put the folder on any web server or static host; docs/publish.md shows GitHub Pages and itch.io
`;
}

/** Why levels are refused, or that they are built all the same: what `gq check` says of each. */
export function refusedInWords(
  { levels }: BuiltPack,
  refused: Levels,
  { force, colors }: { readonly force: boolean | 'built'; readonly colors: Colors },
): string {
  const lines = refused.map((level) => {
    const { file, name, verdict, problems } = level;
    const named = isUnplayable(level) ? '' : ` (${visibleLine(name)})`;
    const paint = verdict === 'completable' || verdict === 'unproven' ? colors.yellow : colors.red;
    const errors = problems.filter(({ severity }) => severity === 'error');
    return `${paint(verdict)} ${visibleLine(file)}${named}: ${whyRefused(level)}\n${showFileProblems(file, errors, colors)}`;
  });
  const count = `${refused.length} of ${plural(levels.length, 'level')}`;
  return `${lines.join('')}${force === 'built' ? `warning: built all the same: ${count}\n` : refusal(count, refused)}`;
}

function refusal(count: string, refused: Levels): string {
  const leaveOut = 'fix them, or leave them out with "ignore" in gq.config.json';
  const anyway = !refused.every(isUnplayable) ? '; --force builds levels that are not known to be completable' : '';
  const never = refused.some(isUnplayable) ? '; nobody can play a level that is not valid, so --force does not build it' : '';
  return `nothing was written, because of ${count}: ${leaveOut}${anyway}${never}\n`;
}
