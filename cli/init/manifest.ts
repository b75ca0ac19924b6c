import { join } from 'node:path';
import { strictJson } from '../../schema/json/index.ts';
import type { PlannedText } from './ci.ts';
import { readText } from './read-text.ts';

type Json = Record<string, unknown>;

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The object that a JSON text holds; null if it holds none, or has a key twice, of which one would be lost in writing. */
export function objectIn(text: string): Json | null {
  const json = strictJson(text.replace(/^\ufeff/, ''));
  return json.ok && isObject(json.value) ? json.value : null;
}

/** Writes an object with the indentation and line ends of the text that it replaces. */
export function likeBefore(value: Json, before: string): string {
  const indent = /^[{[]\r?\n([ \t]+)/.exec(before.trimStart())?.[1] ?? '  ';
  const text = JSON.stringify(value, null, indent) + (/\n\s*$/.test(before) ? '\n' : '');
  return before.includes('\r\n') ? text.replaceAll('\n', '\r\n') : text;
}

const SCRIPT = 'check';
const COMMAND = 'gq check';
const TOOLKIT = 'gravity-quest-toolkit';

/** `npm run check`, in the manifest of the project. */
export function planManifest(folder: string): PlannedText {
  const file = join(folder, 'package.json');
  const before = readText(file);
  if (before === null) return { file, text: `${JSON.stringify({ private: true, scripts: { [SCRIPT]: COMMAND } }, null, 2)}\n` };
  const manifest = objectIn(before);
  if (manifest === null) return { file, text: null, note: 'it is not valid JSON, or has a key twice' };
  const scripts = manifest.scripts ?? {};
  if (!isObject(scripts)) return { file, text: null, note: 'its scripts are not an object' };
  const calling = Object.keys(scripts).find((name) => String(scripts[name]).includes(COMMAND));
  if (calling !== undefined) return { file, text: null, note: `its script "${calling}" checks levels already` };
  if (Object.hasOwn(scripts, SCRIPT)) return { file, text: null, note: `it has another script "${SCRIPT}"` };
  return { file, text: likeBefore({ ...manifest, scripts: { ...scripts, [SCRIPT]: COMMAND } }, before) };
}

/** Whether the project names the toolkit among its dependencies, or is the toolkit. */
export function hasToolkit(folder: string): boolean {
  const manifest = objectIn(readText(join(folder, 'package.json')) ?? '{}');
  if (manifest?.name === TOOLKIT) return true;
  const lists = [manifest?.dependencies, manifest?.devDependencies, manifest?.optionalDependencies];
  return lists.some((list) => isObject(list) && Object.hasOwn(list, TOOLKIT));
}
