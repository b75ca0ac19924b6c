import { existsSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { formatLevel, readLevel } from '../../schema/index.ts';
import { strictJson } from '../../schema/json/index.ts';
import { CONFIG_NAME, configFolders } from '../config/index.ts';
import { repositoryOf, statOrError, walk } from '../io/index.ts';
import { schemaReference } from '../levels/index.ts';
import { Failure, systemReason } from '../terminal/index.ts';
import { type Ci, type PlannedText, planCi, readShippedLevel, readTemplate, readText } from './ci.ts';

export { type Ci, chooseCi } from './ci.ts';

/** What `gq init` is going to do. */
export interface Plan {
  readonly files: readonly PlannedText[];
  /** Whether the project has the toolkit among its dependencies. */
  readonly isInstalled: boolean;
  /** Whether the project is in a repository of git. */
  readonly isRepository: boolean;
}

/** The levels to begin with. Both have runs that complete them. */
const FIRST_LEVELS = ['01-first-pull.level.json', '02-first-swing.level.json'];

const LEVELS = 'levels';

const LEVEL_SCHEMA = 'schema/level.schema.json';

/** The path from a folder to the package, for JSON files in it; where it is not installed yet, where npm will put it. */
function homeOf(folder: string, project: string): string {
  const reference = schemaReference(folder);
  const home = reference?.endsWith(LEVEL_SCHEMA) ? reference.slice(0, -LEVEL_SCHEMA.length - 1) : null;
  const back = relative(resolve(folder), resolve(project)).replaceAll('\\', '/');
  const path = home ?? join(back, 'node_modules/gravity-quest-toolkit').replaceAll('\\', '/');
  if (path === '') return '.';
  return path.startsWith('.') ? path : `./${path}`;
}

/** Why no levels are put into a folder; null if they may be. */
function whyNoLevels(folder: string): string | null {
  const stats = statOrError(folder);
  if (stats instanceof Error) return null;
  if (!stats.isDirectory()) return 'it is a file';
  try {
    const walked = walk(folder, { links: 'listed', hidden: 'entered', passes: (below) => below.endsWith('.level.json') });
    for (const { error } of walked.unreadable) throw error;
    return walked.files.length > 0 ? 'it has levels already' : null;
  } catch (error) {
    throw new Failure(`${folder}: can't be read: ${systemReason(error)}; gq init looks for levels here`);
  }
}

function planLevels(project: string): PlannedText[] {
  const folder = join(project, LEVELS);
  const note = whyNoLevels(folder);
  if (note !== null) return [{ file: folder, text: null, note }];
  return FIRST_LEVELS.map((name) => {
    const read = readLevel(readShippedLevel(name));
    if (!read.ok) throw new Error(`the shipped level ${name} is not valid`);
    const $schema = `${homeOf(folder, project)}/${LEVEL_SCHEMA}`;
    return { file: join(folder, name), text: formatLevel({ ...read.document.file, $schema }) };
  });
}

function planConfig(project: string): PlannedText {
  const file = join(project, CONFIG_NAME);
  const there = configFolders(project)
    .map((folder) => join(folder, CONFIG_NAME))
    .find((one) => existsSync(one));
  if (there !== undefined) {
    const isHere = resolve(there) === resolve(file);
    return { file: isHere ? file : relative('', there), text: null, note: isHere ? 'it exists' : 'it applies here, too' };
  }
  const $schema = `${homeOf(project, project)}/schema/config.schema.json`;
  return { file, text: `${JSON.stringify({ $schema, levels: LEVELS }, null, 2)}\n` };
}

/** A new project gets one, and one in which npm has installed something, so that nobody commits that. */
function planIgnored(project: string): PlannedText[] {
  const isNeeded = !existsSync(join(project, 'package.json')) || existsSync(join(project, 'node_modules'));
  const isIgnored = [project, repositoryOf(project)].some((folder) => existsSync(join(folder, '.gitignore')));
  return isNeeded && !isIgnored ? [{ file: join(project, '.gitignore'), text: 'node_modules/\n' }] : [];
}

/**
 * Finds out what a project lacks. It reads only.
 * @throws Failure if a file of the project can't be read
 */
export function planProject(project: string, ci: Ci): Plan {
  const stats = statOrError(project);
  if (!(stats instanceof Error) && !stats.isDirectory())
    throw new Failure(`${project}: expected a directory for the project, found a file`);
  const config = planConfig(project);
  // a configuration says itself where the levels are
  const levels = config.text === null ? [] : planLevels(project);
  const workflow = planCi(project, ci);
  const files = [
    ...levels,
    config,
    planManifest(project),
    ...(workflow === null ? [] : [workflow]),
    planSettings(project, homeOf(project, project)),
    ...planIgnored(project),
  ];
  return { files, isInstalled: hasToolkit(project), isRepository: existsSync(join(repositoryOf(project), '.git')) };
}

type Json = Record<string, unknown>;

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** The object that a JSON text holds; null if it holds none, or has a key twice, of which one would be lost in writing. */
function objectIn(text: string): Json | null {
  const json = strictJson(text.replace(/^\ufeff/, ''));
  return json.ok && isObject(json.value) ? json.value : null;
}

/** Writes an object with the indentation and line ends of the text that it replaces. */
function likeBefore(value: Json, before: string): string {
  const indent = /^[{[]\r?\n([ \t]+)/.exec(before.trimStart())?.[1] ?? '  ';
  const text = JSON.stringify(value, null, indent) + (/\n\s*$/.test(before) ? '\n' : '');
  return before.includes('\r\n') ? text.replaceAll('\n', '\r\n') : text;
}

const SCRIPT = 'check';
const COMMAND = 'gq check';
const TOOLKIT = 'gravity-quest-toolkit';

/** `npm run check`, in the manifest of the project. */
function planManifest(folder: string): PlannedText {
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
function hasToolkit(folder: string): boolean {
  const manifest = objectIn(readText(join(folder, 'package.json')) ?? '{}');
  if (manifest?.name === TOOLKIT) return true;
  const lists = [manifest?.dependencies, manifest?.devDependencies, manifest?.optionalDependencies];
  return lists.some((list) => isObject(list) && Object.hasOwn(list, TOOLKIT));
}

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
function planSettings(folder: string, home: string): PlannedText {
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
