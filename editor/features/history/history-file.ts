import { formatLevel } from '../../../schema/index.ts';
import { strictJson } from '../../../schema/json/index.ts';
import type { OpenLevel } from '../../core/context/index.ts';
import { chooseFiles, downloadFile } from '../../core/exchange/index.ts';
import { plural } from '../../core/figures/index.ts';
import { readText } from '../../core/files/index.ts';
import { stemOf } from '../../core/levels/index.ts';
import { type PastVersion, VERSION_MAKERS, type VersionBy } from '../../core/versions/index.ts';

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

/** The key by which a file is known as a history; its value is the version of the format. */
const FORMAT = 'gravityQuestHistory';

/** The text of a file with all versions of a level. */
export const formatHistory = (level: string, versions: readonly PastVersion[]): string =>
  `${JSON.stringify({ [FORMAT]: 1, level, versions }, null, 1)}\n`;

const isTexts = (value: unknown): value is string[] => Array.isArray(value) && value.every((one) => typeof one === 'string');

/** A version of a file; null if it is not one, or its level can't be read. */
function versionIn(value: unknown): PastVersion | null {
  if (typeof value !== 'object' || value === null) return null;
  const { time, by, labels, more, changes, name, text } = value as Readonly<Record<string, unknown>>;
  const isTime = typeof time === 'number' && Number.isFinite(time) && Math.abs(time) <= 8.64e15;
  if (!isTime || !VERSION_MAKERS.includes(by as VersionBy) || !isTexts(labels) || typeof text !== 'string') return null;
  if (!(name === null || typeof name === 'string') || !Number.isSafeInteger(more) || (more as number) < 0) return null;
  const reading = readText(text);
  if (!reading.ok) return null;
  return {
    time,
    by: by as VersionBy,
    labels,
    more: more as number,
    changes: typeof changes === 'string' ? changes : '',
    name,
    text: formatLevel(reading.file),
  };
}

/** The versions in the text of a file, and how many could not be read; null if it is not a history. */
export function readHistory(text: string): { readonly versions: readonly PastVersion[]; readonly unread: number } | null {
  const json = strictJson(text);
  if (!json.ok) return null;
  const content = json.value;
  if (typeof content !== 'object' || content === null || (content as { [FORMAT]?: unknown })[FORMAT] !== 1) return null;
  const { versions: listed } = content as { versions?: unknown };
  if (!Array.isArray(listed)) return null;
  const versions = listed.map(versionIn).filter((version) => version !== null);
  return { versions, unread: listed.length - versions.length };
}
