import process from 'node:process';
import { type Colors, colorsFor, PLAIN, widthOf } from '../../colors.ts';
import type { CommandResult, ResultFile } from '../../command.ts';
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
  const files: ResultFile[] = [];
  let output: Required<CommandResult>['output'] = '';
  for (const { name, file } of destinations) {
    if (!PLAIN_FORMATS.includes(name)) throw new Error(`there is no report ${name} of this job`);
    const isJson = name === 'json';
    if (file === null)
      output = isJson
        ? { [Symbol.iterator]: () => json()[Symbol.iterator]() }
        : pretty(colorsFor(process.stdout), widthOf(process.stdout));
    else
      files.push({
        path: file,
        content: isJson ? { [Symbol.iterator]: () => json()[Symbol.iterator]() } : pretty(PLAIN, null),
        mode: 'replace',
      });
  }
  return { output, files };
}

/** Pieces of JSON: an object whose list has any number of items. @param rest the object with all other keys */
export function* jsonWithLevels(levels: Iterable<object>, rest: object): Generator<string> {
  yield `{"version":1,"levels":[`;
  let comma = '';
  for (const level of levels) {
    yield comma + JSON.stringify(level);
    comma = ',';
  }
  const tail = JSON.stringify(rest).slice(1);
  yield tail === '}' ? ']}\n' : `],${tail}\n`;
}
