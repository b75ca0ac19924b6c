import type { OwnRules } from '../default-rules.ts';
import { LEVEL_VERSION } from '../level-constants.ts';
import type { Level } from '../level-types.ts';
import { type JsonObject, MIGRATIONS, migrate } from '../migrate.ts';
import { LFS } from '../pointer-file.ts';
import { toPointer } from '../problem.ts';
import { MAX_FILE_SIZE } from '../read-json.ts';
import { decodeUtf8 } from '../utf8.ts';
import { checkMeaning } from './check-meaning.ts';
import { checkShape } from './check-shape.ts';
import { Failure, inWords } from './failure.ts';
import { LEVEL_SHAPE } from './level-shape.ts';
import { parseJson } from './parse-json.ts';
import { resolveShape } from './resolve-shape.ts';

/** The outcome of {@link readPlainLevel}: the level, or what is wrong with its file. */
export type PlainLevelReading =
  | {
      /** The file is a valid level. */
      readonly ok: true;
      /** The level with every default filled in. */
      readonly level: Level;
    }
  | {
      /** The file is not a valid level. */
      readonly ok: false;
      /** The first thing that is wrong: where, what was expected, what was found. */
      readonly message: string;
      /** JSON pointer of the value concerned; '' is the whole file. For a missing key: the object that lacks it. */
      readonly pointer: string;
    };

/** Options of {@link readPlainLevel}. */
export interface ReadPlainLevelOptions {
  /** Rules that the level's folder sets; they apply where the level has none of its own. None when left out. */
  readonly rules?: OwnRules;
}

// a key of a megabyte must not appear in a message
const MAX_POINTER = 500;

/** The pointer of a path; if a key makes it too long, that of the value around it. */
function pointerOf(path: Failure['path']): string {
  const pointer = toPointer(path);
  return pointer.length > MAX_POINTER ? pointerOf(path.slice(0, -1)) : pointer;
}

function textOf(source: string | Uint8Array): string {
  if (typeof source !== 'string' && !(source instanceof Uint8Array)) {
    throw new Failure(`expected the text or the bytes of a level file, found ${inWords(source)}`, []);
  }
  if (source.length > MAX_FILE_SIZE) throw new Failure('expected at most 8 MiB, found more', []);
  const { text, bad } = typeof source === 'string' ? { text: source, bad: null } : decodeUtf8(source);
  if (bad !== null) throw new Failure(`expected UTF-8, found the byte ${bad.byte.toString(16)} at offset ${bad.at}`, []);
  if (text.startsWith('\ufeff')) throw new Failure('expected {, found a byte order mark; gq fmt removes it', []);
  // what a server gives that has a repository without what git lfs pull fetches
  if (LFS.test(text)) throw new Failure('expected a level, found a Git LFS pointer', []);
  return text;
}

/** The file in the present version of the format. */
function migrated(file: unknown): unknown {
  if (typeof file !== 'object' || file === null || Array.isArray(file) || !Object.hasOwn(file, 'version')) return file;
  const { version } = file as JsonObject;
  if (typeof version !== 'number' || !Number.isInteger(version) || version === LEVEL_VERSION) return file;
  if (version > LEVEL_VERSION) {
    throw new Failure(`expected a version up to ${LEVEL_VERSION}, found ${version}: update gravity-quest-toolkit`, ['version']);
  }
  // for an older version without a migration the file stays as it is, and its version is found wrong
  const isKnown = version >= 0 && MIGRATIONS.filter(({ from }) => from >= version).length === LEVEL_VERSION - version;
  return isKnown ? migrate(file as JsonObject, version, LEVEL_VERSION, MIGRATIONS) : file;
}

/**
 * Reads a level file in a game: the same files are valid as for {@link readLevel}, and give the same level. It needs no zod and a
 * few kB only, so it reports the first mistake alone. Throws nothing for any content.
 *
 * @param source - the text of the file, or its bytes
 * @param options - rules of the folder
 * @returns the level, or the first mistake and its place
 *
 * @example
 * ```ts
 * const reading = readLevel(await (await fetch('levels/01-first-pull.level.json')).text());
 * if (!reading.ok) throw new Error(reading.message);
 * const player = createPlayer(reading.level);
 * ```
 */
export function readPlainLevel(source: string | Uint8Array, { rules = {} }: ReadPlainLevelOptions = {}): PlainLevelReading {
  try {
    const file = migrated(parseJson(textOf(source)));
    checkShape(file, LEVEL_SHAPE);
    checkMeaning(file as JsonObject);
    return { ok: true, level: resolveShape(file as JsonObject, rules) };
  } catch (failure) {
    if (!(failure instanceof Failure)) throw failure;
    const pointer = pointerOf(failure.path);
    const place = failure.place ?? pointer;
    return { ok: false, message: place === '' ? failure.message : `${place}: ${failure.message}`, pointer };
  }
}
