import type { Scene } from 'phaser';
import type { Scene as Compiled } from '../../engine/index.ts';
import { fieldsOf, KINDS, type Level, OBJECT_KINDS, type ObjectKind } from '../../schema/basics/index.ts';

const SUPPORTED = 'Phaser 3.90 to 4.x is supported.';

type Unknown = Readonly<Record<string, unknown>>;

const isObject = (value: unknown): value is Unknown => typeof value === 'object' && value !== null;

const kindOf = (value: unknown): string => {
  if (value === null) return 'null';
  if (Array.isArray(value)) return 'an array';
  return typeof value === 'object' ? 'an object' : typeof value === 'function' ? 'a function' : typeof value;
};

/** The version of a build of Phaser, such as `4.2.1`; null if it has none. */
const versionOf = (phaser: unknown): string | null => {
  const version = isObject(phaser) || typeof phaser === 'function' ? (phaser as Unknown).VERSION : null;
  return typeof version === 'string' ? version : null;
};

/** Whether a version is supported. */
export function isSupported(version: string): boolean {
  const [major, minor] = version.split('.').map((part) => Number.parseInt(part, 10));
  return major === 4 || (major === 3 && minor >= 90);
}

/** The version of the Phaser that a script tag has put on the page. */
const onPage = (): string | null => versionOf((globalThis as Unknown).Phaser);

/**
 * Makes sure that a build of Phaser is supported.
 * @throws {TypeError} which names what was found
 */
export function requirePhaser(caller: string, phaser: unknown): void {
  const version = versionOf(phaser);
  if (version === null) {
    throw new TypeError(
      `${caller}: expected Phaser, found ${phaser === undefined ? 'undefined' : `${kindOf(phaser)} without VERSION`}. ` +
        `${SUPPORTED} Pass what \`import * as Phaser from 'phaser'\` gives, or load its script before this one.`,
    );
  }
  if (!isSupported(version))
    throw new TypeError(`${caller}: expected Phaser 3.90 to 4.x, found Phaser ${version}. Install \`phaser@4\`.`);
}

/**
 * Makes sure that a value is a running scene of a supported Phaser. Scenes do not know their version, so it is judged by what
 * they have.
 * @throws {TypeError} which names what was found
 */
export function requireScene(caller: string, scene: unknown): asserts scene is Scene {
  const found = onPage();
  const beside = found === null ? '' : ` This page has Phaser ${found}.`;
  const fail = (what: string, hint: string): never => {
    throw new TypeError(`${caller}: expected a Phaser scene, found ${what}.${beside} ${SUPPORTED} ${hint}`);
  };
  if (!isObject(scene)) {
    return fail(kindOf(scene), "Call it in the scene's create(), with `this` as the first argument.");
  }
  if (found !== null && !isSupported(found)) return fail('one of an unsupported version', 'Install `phaser@4`.');
  const { sys, game } = scene;
  if (!isObject(sys)) {
    const isOld = isObject(game) && 'state' in game && 'stage' in game;
    return isOld
      ? fail('a state of Phaser 2', 'Install `phaser@4`.')
      : fail('an object without `sys`', 'Pass the scene itself: an instance of a class that extends Phaser.Scene.');
  }
  const { events, displayList, textures, add } = sys;
  if (!isObject(displayList) || !isObject(events)) {
    return fail('a scene that has not started', "Call createRunner in the scene's create(), not in its constructor.");
  }
  const parts: readonly (readonly [string, unknown, string])[] = [
    ['sys.events.on', events, 'on'],
    ['textures.addCanvas', textures ?? scene.textures, 'addCanvas'],
    ['add.container', add ?? scene.add, 'container'],
    ['add.image', add ?? scene.add, 'image'],
  ];
  const missing = parts.filter(([, owner, name]) => !isObject(owner) || typeof owner[name] !== 'function').map(([name]) => name);
  if (missing.length > 0) fail(`a scene without ${missing.join(', ')}`, 'Use another version of Phaser.');
}

/** What a level lacks: keys such as `range` or `asteroids[0].hot`. A level file may leave out what a level has. */
function lacking(level: Unknown): string[] {
  const missing: string[] = [];
  const look = (owner: Unknown, key: string, type: string, at: string) => {
    if (typeof owner[key] !== type) missing.push(`${at}${key}`);
  };
  const lookAt = (kind: ObjectKind, object: unknown, at: string) => {
    if (!isObject(object)) missing.push(at);
    else for (const [name, { type }] of fieldsOf(kind)) look(object, name, type === 'flag' ? 'boolean' : 'number', `${at}.`);
  };
  look(level, 'range', 'number', '');
  look(level, 'recoil', 'boolean', '');
  for (const kind of OBJECT_KINDS) {
    const { list } = KINDS[kind];
    const found = level[list ?? kind];
    if (list === null) lookAt(kind, found, kind);
    else if (!Array.isArray(found)) missing.push(list);
    else for (const [i, object] of found.entries()) lookAt(kind, object, `${list}[${i}]`);
  }
  if (!Array.isArray(level.runs)) missing.push('runs');
  return missing;
}

const isLevel = (value: unknown): boolean => isObject(value) && lacking(value).length === 0;

const READ =
  'Read the file with readLevel of gravity-quest-toolkit/game, which also says what is wrong with it: ' +
  '`const reading = readLevel(text); if (reading.ok) createRunner(scene, reading.level)`.';

/**
 * Makes sure that a value is a level, or a scene compiled from one.
 * @throws {TypeError} which names what was found
 */
export function requireLevel(caller: string, level: unknown): asserts level is Level | Compiled {
  if (isObject(level) && 'targets' in level && isLevel(level.level)) return;
  if (isLevel(level)) return;
  throw new TypeError(`${caller}: expected a level, found ${whatIsIt(level)}. ${READ}`);
}

function whatIsIt(level: unknown): string {
  if (typeof level === 'string') return 'a string';
  if (!isObject(level)) return kindOf(level);
  if (level.ok === true) return 'what readLevel returned: pass its `level`';
  if (level.ok === false) {
    const { message, problems } = level;
    const [first] = Array.isArray(problems) ? problems : [];
    const why = typeof message === 'string' ? message : isObject(first) ? first.message : '';
    return `what readLevel returned for a file that is not valid${why === '' ? '' : ` (${String(why)})`}`;
  }
  if (isObject(level.astronaut)) {
    const missing = lacking(level);
    const more = missing.length > 3 ? ` and ${missing.length - 3} more` : '';
    const what =
      'version' in level ? 'the content of a level file, in which defaults are left out' : 'an object that is not complete';
    return `${what} (it lacks ${missing.slice(0, 3).join(', ')}${more})`;
  }
  return Array.isArray(level) ? 'an array' : 'an object that is none';
}
