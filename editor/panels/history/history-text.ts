import { formatLevel } from '../../../schema/index.ts';
import { strictJson } from '../../../schema/json/index.ts';
import { readText } from '../../files/index.ts';
import { type PastVersion, VERSION_MAKERS, type VersionBy } from '../../versions/index.ts';

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
