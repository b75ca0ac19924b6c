import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { createVerifier, ENGINE_ID, levelHash, type PlayVerifier } from '../../game/index.ts';
import { type Level, type OwnRules, readLevel } from '../../schema/index.ts';
import { Failure, namedPath, systemReason } from '../terminal/index.ts';

/** What verifying plays needs of an engine: of this toolkit, or of an older one. */
export interface EngineModule {
  readonly id: string;
  /** null if the bytes are no level that this engine can read. */
  readLevel(bytes: Uint8Array, rules: OwnRules): Level | null;
  levelHash(level: Level): string;
  createVerifier(level: Level): PlayVerifier;
}

type LevelReader = typeof readLevel;

function moduleOf(id: string, game: GameModule, read: LevelReader): EngineModule {
  return {
    id,
    readLevel(bytes, rules) {
      const reading = read(bytes, { rules });
      return reading.ok ? reading.level : null;
    },
    levelHash: game.levelHash,
    createVerifier: game.createVerifier,
  };
}

interface GameModule {
  readonly ENGINE_ID: string;
  readonly levelHash: (level: Level) => string;
  readonly createVerifier: (level: Level) => PlayVerifier;
}

/** The engine of this toolkit. */
export const ownEngine: EngineModule = moduleOf(ENGINE_ID, { ENGINE_ID, levelHash, createVerifier }, readLevel);

/** Where the built files of an engine may be in its folder: as built, as unpacked from a package, and as installed by npm. */
const LAYOUTS = ['.', 'dist', 'package/dist', 'node_modules/gravity-quest-toolkit/dist'];

/**
 * The engines in a folder: where the built files of each are, by its identity.
 * @throws Failure if the folder can't be read
 */
export function enginesIn(folder: string): ReadonlyMap<string, string> {
  const found = new Map<string, string>();
  for (const id of namesIn(folder)) {
    const layout = LAYOUTS.find((path) => existsSync(join(folder, id, path, 'game/index.js')));
    if (/^[0-9a-f]{16}$/.test(id) && layout !== undefined) found.set(id, join(folder, id, layout));
  }
  return found;
}

function namesIn(folder: string): string[] {
  try {
    return readdirSync(folder).sort();
  } catch (error) {
    throw new Failure(`--engines ${namedPath(folder)}: ${systemReason(error)}; expected a directory of engines`);
  }
}

/**
 * Loads an engine from its folder.
 * @throws Failure if it is not what its folder says
 */
export async function loadEngine(built: string, id: string): Promise<EngineModule> {
  const at = (path: string): string => pathToFileURL(join(built, path)).href;
  let game: Partial<GameModule>;
  let schema: { readonly readLevel?: LevelReader };
  try {
    [game, schema] = await Promise.all([import(at('game/index.js')), import(at('schema/index.js'))]);
  } catch (error) {
    throw new Failure(
      `${namedPath(built)}: the engine can't be loaded: ${error instanceof Error ? error.message.split('\n')[0] : String(error)}; expected a package with what it depends on, as npm install makes it`,
    );
  }
  const { ENGINE_ID: found, levelHash: hash, createVerifier: create } = game;
  if (typeof hash !== 'function' || typeof create !== 'function' || typeof schema.readLevel !== 'function') {
    throw new Failure(`${namedPath(built)}: expected game/index.js and schema/index.js of a toolkit that verifies plays`);
  }
  if (found !== id) throw new Failure(`${namedPath(built)}: expected engine ${id}, as its folder says; found ${found}`);
  return moduleOf(id, { ENGINE_ID: id, levelHash: hash, createVerifier: create }, schema.readLevel);
}
