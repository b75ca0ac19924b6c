import { join } from 'node:path';
import type { PlannedText } from './ci.ts';
import { likeBefore, objectIn } from './manifest.ts';
import { readText } from './read-text.ts';
import { readTemplate } from './templates.ts';

const KEY = 'json.schemas';

interface SchemaEntry {
  readonly fileMatch: readonly string[];
  readonly url: string;
}

const matches = (entry: unknown): readonly unknown[] => {
  const found = (entry as { readonly fileMatch?: unknown } | null)?.fileMatch;
  return Array.isArray(found) ? found : [found];
};

/** The settings by which VS Code completes and checks levels and the configuration; other settings stay as they are. */
export function planSettings(folder: string, home: string): PlannedText {
  const file = join(folder, '.vscode', 'settings.json');
  const template = readTemplate('vscode/settings.json').replaceAll('./node_modules/gravity-quest-toolkit', home);
  const before = readText(file);
  if (before === null || before.trim() === '') return { file, text: template };
  const settings = objectIn(before);
  const byHand = 'the settings to add are in templates/vscode/settings.json of the package';
  if (settings === null) return { file, text: null, note: `it is no plain JSON (comments?); ${byHand}` };
  const wanted = (JSON.parse(template) as Record<string, SchemaEntry[]>)[KEY];
  const there = settings[KEY] ?? [];
  if (!Array.isArray(there)) return { file, text: null, note: `its "${KEY}" is not a list; ${byHand}` };
  const known = there.flatMap(matches);
  const missing = wanted.filter(({ fileMatch }) => !fileMatch.some((pattern) => known.includes(pattern)));
  if (missing.length === 0) return { file, text: null, note: 'it has the schemas already' };
  return { file, text: likeBefore({ ...settings, [KEY]: [...there, ...missing] }, before) };
}
