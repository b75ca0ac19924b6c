import process from 'node:process';
import type { CommandResult, ResultFile } from '../../command.ts';
import { type Colors, colorsFor, PLAIN, widthOf } from '../../io/index.ts';
import { inPieces } from '../../report-parts/index.ts';
import type { Destination, ReporterName } from '../../reporters/index.ts';

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
