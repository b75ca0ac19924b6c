import type { PlayVerifier, VerifiedPlay, VerifyOptions } from '../../game/index.ts';
import type { OwnRules } from '../../schema/index.ts';
import { readBytes } from '../io/index.ts';
import { type EngineModule, loadEngine, ownEngine } from './engine-module.ts';

/** A play to replay, for this thread or another. */
export interface ReplayTask {
  readonly bytes: Uint8Array;
  /** The file of its level, and the level's hash. */
  readonly level: { readonly file: string; readonly hash: string };
  readonly rules: OwnRules;
  /** The engine to use, and the folder with its built files; null: that of this toolkit. */
  readonly engine: { readonly id: string; readonly folder: string } | null;
  readonly options: VerifyOptions;
}

const engines = new Map<string, Promise<EngineModule>>();
const verifiers = new Map<string, PlayVerifier>();

/** So many levels are kept compiled. */
const MOST_VERIFIERS = 256;

async function engineOf(engine: ReplayTask['engine']): Promise<EngineModule> {
  if (engine === null) return ownEngine;
  const loading = engines.get(engine.folder) ?? loadEngine(engine.folder, engine.id);
  engines.set(engine.folder, loading);
  return loading;
}

async function verifierOf({ level, rules, engine }: ReplayTask): Promise<PlayVerifier | null> {
  const key = `${engine?.folder ?? ''}\n${level.file}\n${level.hash}`;
  const kept = verifiers.get(key);
  if (kept !== undefined) return kept;
  const module = await engineOf(engine);
  const read = module.readLevel(readBytes(level.file), rules);
  if (read === null) return null;
  const made = module.createVerifier(read);
  if (verifiers.size >= MOST_VERIFIERS) verifiers.clear();
  verifiers.set(key, made);
  return made;
}

/**
 * Replays plays, one after the other.
 * @throws Failure if a level file can't be read any more
 */
export async function replayAll(tasks: readonly ReplayTask[]): Promise<(VerifiedPlay | null)[]> {
  const verified: (VerifiedPlay | null)[] = [];
  for (const task of tasks) {
    const verifier = await verifierOf(task);
    verified.push(verifier === null ? null : verifier.verify(task.bytes, task.options));
  }
  return verified;
}
