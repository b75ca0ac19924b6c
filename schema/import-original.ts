import { formatValue } from './format-value.ts';
import { withIds } from './ids.ts';
import { LEVEL_VERSION, type LevelFile, LIMITS } from './level.ts';
import { type Finding, MAX_FINDINGS, type Path, type Problem, toWords } from './problem.ts';
import { readJson, toProblems } from './read-json.ts';

export interface ImportedLevel {
  /** `level-NN` by place in the list, from 0; `level-01` for a single object. */
  readonly slug: string;
  readonly file: LevelFile;
}

export type ImportReading =
  | {
      readonly ok: true;
      readonly levels: ImportedLevel[];
      /** What was passed over, one line each: empty placeholders, keys that mean nothing here. */
      readonly notes: string[];
    }
  | { readonly ok: false; readonly problems: Problem[]; readonly text: string };

type Json = { readonly [key: string]: unknown };

const isObject = (value: unknown): value is Json => typeof value === 'object' && value !== null && !Array.isArray(value);

/** Reads values of the original's objects, and collects what is wrong and what is passed over. */
class OriginalReader {
  readonly findings: Finding[] = [];
  readonly ignored = new Map<string, number>();

  find(code: Finding['code'], path: Path, message: string, hint: string): void {
    if (this.findings.length >= MAX_FINDINGS) return;
    const words = path.length === 0 ? '' : `${toWords(path)}: `;
    this.findings.push({ code, message: `${words}${message}`, hint, path, part: 'value' });
  }

  ignoreOthers(object: Json, known: readonly string[]): void {
    for (const key of Object.keys(object)) if (!known.includes(key)) this.ignored.set(key, (this.ignored.get(key) ?? 0) + 1);
  }

  missing(path: Path, key: string): void {
    const where = path.length === 0 ? '' : ` in ${toWords(path)}`;
    this.findings.push({
      code: 'missing-key',
      message: `the key "${key}" is missing${where}`,
      hint: `Add "${key}".`,
      path,
      part: 'value',
    });
  }

  /** A number from `least` to `most`; undefined when the key is missing or its value is reported. */
  number(object: Json, key: string, path: Path, least: number, most: number): number | undefined {
    if (!Object.hasOwn(object, key)) return undefined;
    const value = object[key];
    const at = [...path, key];
    if (typeof value !== 'number') {
      this.find('wrong-type', at, `expected a number, found ${formatValue(value)}`, 'Write a number.');
    } else if (value < least || value > most) {
      this.find(
        'out-of-limits',
        at,
        `expected a number from ${least} to ${most}, found ${value}`,
        'Write a number within these limits.',
      );
    } else {
      return value;
    }
    return undefined;
  }

  /** A radius or range in px, written as a number or as a text of digits. */
  size(object: Json, key: string, path: Path): number | undefined {
    if (!Object.hasOwn(object, key)) return undefined;
    const value = object[key];
    const size = typeof value === 'string' && /^\d+(\.\d+)?$/.test(value) ? Number(value) : value;
    const at = [...path, key];
    if (typeof size !== 'number') {
      this.find('wrong-type', at, `expected a number or a text of digits, found ${formatValue(value)}`, 'Write a number.');
    } else if (size < LIMITS.leastRadius || size > LIMITS.radius) {
      const limits = `from ${LIMITS.leastRadius} to ${LIMITS.radius}`;
      this.find('out-of-limits', at, `expected a number ${limits}, found ${size}`, `Write a number ${limits}.`);
    } else {
      return size;
    }
    return undefined;
  }

  place(object: Json, path: Path): { x: number; y: number } {
    for (const key of ['x', 'y']) if (!Object.hasOwn(object, key)) this.missing(path, key);
    const x = this.number(object, 'x', path, -LIMITS.coordinate, LIMITS.coordinate) ?? 0;
    const y = this.number(object, 'y', path, -LIMITS.coordinate, LIMITS.coordinate) ?? 0;
    return { x, y };
  }

  one(level: Json, key: string, path: Path): Json | null {
    if (!Object.hasOwn(level, key)) {
      this.missing(path, key);
      return null;
    }
    const value = level[key];
    if (isObject(value)) return value;
    this.find(
      'wrong-type',
      [...path, key],
      `expected an object in { }, found ${formatValue(value)}`,
      'Write an object with x and y.',
    );
    return null;
  }

  list<T>(level: Json, key: string, path: Path, read: (object: Json, path: Path) => T): T[] | undefined {
    if (!Object.hasOwn(level, key)) return undefined;
    const value = level[key];
    const at = [...path, key];
    if (!Array.isArray(value)) {
      this.find('wrong-type', at, `expected a list in [ ], found ${formatValue(value)}`, 'Write a list of objects.');
      return undefined;
    }
    if (value.length > LIMITS.objects) {
      this.find('too-many', at, `expected at most ${LIMITS.objects} entries, found ${value.length}`, 'Remove entries.');
      return undefined;
    }
    const objects: T[] = [];
    for (let i = 0; i < value.length && this.findings.length < MAX_FINDINGS; i++) {
      const entry: unknown = value[i];
      if (isObject(entry)) objects.push(read(entry, [...at, i]));
      else
        this.find(
          'wrong-type',
          [...at, i],
          `expected an object in { }, found ${formatValue(entry)}`,
          'Write an object with x and y.',
        );
    }
    return objects.length === 0 ? undefined : objects;
  }
}

const LEVEL_KEYS = ['player', 'target', 'asteroids', 'novae', 'antiForceFields', 'aliens', 'goodies', 'maxDistance'];
const CIRCLE_KEYS = ['x', 'y', 'radius'];

function readLevelObject(reader: OriginalReader, level: Json, path: Path, name: string, recoil: boolean): LevelFile {
  reader.ignoreOthers(level, LEVEL_KEYS);
  const circle = (object: Json, at: Path, keys = CIRCLE_KEYS) => {
    reader.ignoreOthers(object, keys);
    return { ...reader.place(object, at), radius: reader.size(object, 'radius', at) };
  };
  const sized = (object: Json, at: Path, keys = CIRCLE_KEYS) => {
    if (!Object.hasOwn(object, 'radius')) reader.missing(at, 'radius');
    const { x, y, radius } = circle(object, at, keys);
    return { x, y, radius: radius ?? 1 };
  };
  const asteroid = (object: Json, at: Path) => {
    const { enemy } = object;
    if (Object.hasOwn(object, 'enemy') && typeof enemy !== 'boolean') {
      reader.find(
        'wrong-type',
        [...at, 'enemy'],
        `expected true or false, found ${formatValue(enemy)}`,
        'Write true for a hot asteroid.',
      );
    }
    return { ...sized(object, at, [...CIRCLE_KEYS, 'enemy']), hot: enemy === true ? true : undefined };
  };

  const player = reader.one(level, 'player', path) ?? { x: 0, y: 0 };
  const playerPath = [...path, 'player'];
  reader.ignoreOthers(player, ['x', 'y', 'vx', 'vy']);
  const speed = (key: string) => reader.number(player, key, playerPath, -LIMITS.velocity, LIMITS.velocity);
  return {
    version: LEVEL_VERSION,
    name,
    astronaut: { ...reader.place(player, playerPath), vx: speed('vx'), vy: speed('vy') },
    blackHole: circle(reader.one(level, 'target', path) ?? { x: 0, y: 0 }, [...path, 'target']),
    range: reader.size(level, 'maxDistance', path),
    recoil: recoil ? true : undefined,
    asteroids: reader.list(level, 'asteroids', path, asteroid),
    novae: reader.list(level, 'novae', path, sized),
    repulsors: reader.list(level, 'antiForceFields', path, sized),
    aliens: reader.list(level, 'aliens', path, circle),
    minerals: reader.list(level, 'goodies', path, circle),
  };
}

/**
 * Reads levels of the original game: a JSON list of its level objects, or one of them. Never throws for any input.
 * @param options.recoil whether the levels get recoil, which the original has
 */
export function importOriginal(source: Uint8Array | string, options: { readonly recoil: boolean }): ImportReading {
  const json = readJson(source, 'skip');
  if (!json.ok) return json;
  const { text, value, locator } = json;
  const reader = new OriginalReader();
  const levels: ImportedLevel[] = [];
  const skipped: string[] = [];
  const isList = Array.isArray(value);
  const entries: readonly unknown[] = isList ? value : [value];
  for (let i = 0; i < entries.length && reader.findings.length < MAX_FINDINGS; i++) {
    const entry = entries[i];
    const path: Path = isList ? [i] : [];
    const number = isList ? i : 1;
    if (!isObject(entry)) {
      const expected = isList ? 'an object in { }' : 'a level object of the original game or a list of them';
      reader.find(
        'wrong-type',
        path,
        `expected ${expected}, found ${formatValue(entry)}`,
        'Write an object with player and target.',
      );
    } else if (Object.keys(entry).length === 0) {
      skipped.push(isList ? `[${i}]` : '{}');
    } else {
      const file = readLevelObject(reader, entry, path, `Level ${number}`, options.recoil);
      levels.push({ slug: `level-${String(number).padStart(2, '0')}`, file: withIds(file) });
    }
  }
  const findings = [...json.findings, ...reader.findings];
  if (findings.length === 0 && levels.length === 0) {
    const hint = 'Check that it is the file with the level objects.';
    findings.push({ code: 'nothing-to-import', message: 'there is no level in this file', hint, path: [], part: 'value' });
  }
  if (findings.length > 0) return { ok: false, problems: toProblems(findings, locator), text };

  const notes: string[] = [];
  if (skipped.length > 0) notes.push(`skipped ${skipped.join(', ')}: empty (placeholders of the menu)`);
  if (reader.ignored.size > 0) {
    const keys = [...reader.ignored].map(([key, count]) => `${key} (${count} times)`.replace('(1 times)', '(once)'));
    notes.push(`ignored keys without a meaning here: ${keys.join(', ')}`);
  }
  return { ok: true, levels, notes };
}
