import type { OpenLevel } from '../../core/context/index.ts';
import { chooseFiles, downloadFile } from '../../core/exchange/index.ts';
import { plural } from '../../core/figures/index.ts';
import { stemOf } from '../../core/levels/index.ts';
import type { PastVersion } from '../../core/versions/index.ts';
import { formatHistory, readHistory } from './history-text.ts';

/** Saves all versions of a level as one file. @returns what was done, as a sentence */
export async function exportHistory({ opened }: OpenLevel): Promise<string> {
  const list = opened.versions.store.getState() ?? [];
  const versions: PastVersion[] = [];
  for (const version of list) {
    const text = await opened.versions.text(version);
    const { time, by, labels, more, changes, name } = version;
    if (text !== null) versions.push({ time, by, labels, more, changes, name, text });
  }
  const blob = new Blob([formatHistory(opened.id(), versions)], { type: 'application/json' });
  downloadFile({ name: `${stemOf(opened.id())}.history.json`, blob });
  const lost = list.length - versions.length;
  return `${plural(versions.length, 'version')} exported${lost === 0 ? '' : `; ${lost} could not be read`}.`;
}

/** Adds the versions of a file that the user chooses. @returns what was done, as a sentence */
export async function importHistory({ opened }: OpenLevel): Promise<string> {
  const [file] = (await chooseFiles()) ?? [];
  if (file === undefined) return '';
  const read = readHistory(await file.text());
  if (read === null) return `${file.name} is not an exported history.`;
  const added = await opened.versions.import(read.versions);
  if (added === null) return 'They could not be added: the database does not answer or is full.';
  const known = read.versions.length - added;
  const rest = [...(known === 0 ? [] : [`${known} known already`]), ...(read.unread === 0 ? [] : [`${read.unread} unreadable`])];
  return `${plural(added, 'version')} added${rest.length === 0 ? '' : ` (${rest.join(', ')})`}.`;
}
